#pragma once
#include <Eigen/Core>
#include <cmath>

#include "ContourMath.h"
#include "OutOfRound.h"
#include "ReadThickness.h"
#include "ThinZona.h"

namespace pellucida {

/// The cell at rest, in the frame that moves with the holder (px): learnt while nothing touches it.
struct RestGeometry {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  OutOfRound shape;  ///< of the outer membrane about its circle
  double outer_radius = 0.0;
  double inner_radius = 0.0;
  double outer_sigma_px = 0.0;   ///< usual standard deviation of a place of the outer membrane, where networks read it
  ReadThickness read_thickness;  ///< of the zona, where networks read it
  ThinZonaMean thin_zona;        ///< of frames in which no inner membrane is followed
  int frame_count = 0;           ///< undisturbed frames that went in
  bool seen_free = false;        ///< false while only the undeformed side was seen

  /// Takes in one frame's circle, what is beyond it, and `outer_sigma_px`; the mean of the last `memory` frames is
  /// kept.
  void learn(const Eigen::Vector2d& center_now, double outer_now, double inner_now, const OutOfRound& shape_now,
             double sigma_now_px, int memory = 60) {
    frame_count = std::min(frame_count + 1, memory);
    const double part = 1.0 / frame_count;
    center += part * (center_now - center);
    outer_radius += part * (outer_now - outer_radius);
    inner_radius += part * (inner_now - inner_radius);
    outer_sigma_px += part * (sigma_now_px - outer_sigma_px);
    shape.mix(shape_now, part);
    seen_free = true;
  }

  /// Distance of the resting outer membrane from its centre along `outward` (unit, image); the cell has turned by
  /// `angle_rad`.
  double outer_at(const Eigen::Vector2d& outward, double angle_rad) const {
    return outer_radius + shape.at(outward, angle_rad);
  }

  /// Where the line through `tip` along `direction` first meets the resting outer membrane; the closest point of a
  /// circle when the line passes beside it. `center_now` is the rest centre in the image, `angle_rad` as above.
  Eigen::Vector2d entry_point(const Eigen::Vector2d& center_now, const Eigen::Vector2d& tip,
                              const Eigen::Vector2d& direction, double angle_rad) const {
    constexpr int kRounds = 4;
    const Eigen::Vector2d from_center = tip - center_now;
    const Eigen::Vector2d across = from_center - from_center.dot(direction) * direction;
    double radius_px = outer_radius;
    Eigen::Vector2d entry = -direction;
    for (int round = 0; round < kRounds; ++round) {
      const double inside = radius_px * radius_px - across.squaredNorm();
      entry = inside <= 0.0 ? Eigen::Vector2d(radius_px * across.normalized())
                            : Eigen::Vector2d(across - std::sqrt(inside) * direction);
      radius_px = outer_at(entry.normalized(), angle_rad);
    }
    return center_now + entry;
  }
};

/// Where the line through `origin` along `direction` crosses the closed contour first, as a signed way along
/// `direction` from `origin`. `fallback` when it never does.
inline double first_crossing(const Eigen::Matrix2Xd& points, const Eigen::Vector2d& origin,
                             const Eigen::Vector2d& direction, double fallback) {
  const Eigen::Index n = points.cols();
  double best = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = points.col(i) - origin, b = points.col(i + 1 == n ? 0 : i + 1) - origin;
    const double sa = direction.x() * a.y() - direction.y() * a.x();
    const double sb = direction.x() * b.y() - direction.y() * b.x();
    if ((sa <= 0.0) == (sb <= 0.0)) continue;
    best = std::min(best, direction.dot(a + sa / (sa - sb) * (b - a)));
  }
  return std::isfinite(best) ? best : fallback;
}

/// Half the distance, across the axis, between the crests on both sides of the dimple: from the contour's point nearest
/// the axis under the needle each side climbs to its point farthest along `outward` (unit, cell to needle). 0 without a
/// dimple.
inline double dimple_radius(const Eigen::Matrix2Xd& points, const Eigen::Vector2d& center, const Eigen::Vector2d& apex,
                            const Eigen::Vector2d& outward) {
  const Eigen::Index n = points.cols();
  Eigen::Index nearest = 0;
  for (Eigen::Index i = 1; i < n; ++i)
    if ((points.col(i) - apex).squaredNorm() < (points.col(nearest) - apex).squaredNorm()) nearest = i;
  const Eigen::Vector2d across(-outward.y(), outward.x());
  const auto crest = [&](int step) {
    Eigen::Index best = nearest;
    for (Eigen::Index k = 1; k < n / 3; ++k) {
      const Eigen::Index i = contour::wrap(nearest + step * k, n);
      if ((points.col(i) - points.col(best)).dot(outward) > 0.0) best = i;
    }
    const auto height = [&](Eigen::Index i) { return (points.col(contour::wrap(i, n)) - center).dot(outward); };
    const auto place = [&](Eigen::Index i) { return (points.col(contour::wrap(i, n)) - center).dot(across); };
    const double a = height(best - 1), b = height(best), c = height(best + 1), bend = a - 2.0 * b + c;
    const double part = bend < 0.0 ? std::clamp(0.5 * (a - c) / bend, -0.5, 0.5) : 0.0;
    return place(best) + part * 0.5 * (place(best + 1) - place(best - 1));
  };
  return 0.5 * std::abs(crest(+1) - crest(-1));
}

}  // namespace pellucida
