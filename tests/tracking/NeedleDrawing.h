#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <vector>

#include "ToolFinder.h"
#include "tracking/PixelView.h"

namespace pellucida::test {

/// A needle as a cone with a round tip or one cut off straight, as two dark lines or as a dark wedge, of known place,
/// direction and blur; lengths in px.
struct NeedleDrawing {
  Eigen::Vector2d tip{180.3, 171.6};
  double angle_rad = 0.0;  // of the shaft, from the tip outwards
  double tip_radius = 2.0, slope = 0.045, blur = 1.0, depth = 0.45, noise = 0.01;
  bool wedge = false, straight = false;
  double tapered_px = 1e9;  // so far behind the tip it is as wide as it gets
  // A dark line across, this far ahead of the tip: a membrane, straight or with its centre so far behind the line.
  // Negative: none.
  double membrane_ahead = -1.0, membrane_radius = 0.0;
  // A dark disc on the shaft, its centre so far behind the tip. Negative: none.
  double disc_behind_px = -1.0, disc_radius_px = 11.0;
  unsigned seed = 1;

  /// Light through a membrane's line, `away` px from its middle.
  static double membrane_light(double away) { return 1.0 - 0.4 * std::exp(-0.5 * away * away / (1.2 * 1.2)); }

  Eigen::Vector2d direction() const { return {-std::cos(angle_rad), -std::sin(angle_rad)}; }
};

inline void PrintTo(const NeedleDrawing& d, std::ostream* out) {
  *out << (d.wedge ? "wedge" : "lines") << " at " << d.angle_rad << " rad, blur " << d.blur << ", noise " << d.noise;
}

/// An 8-bit picture that lives as long as this.
struct NeedlePicture {
  static constexpr int kWidth_px = 420, kHeight_px = 340;
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(kWidth_px * kHeight_px);

  ImageView view() const { return view_of_bytes(pixels, kWidth_px, kHeight_px, 1.0); }
};

inline NeedlePicture draw(const NeedleDrawing& d) {
  NeedlePicture picture;
  std::mt19937 random(d.seed);
  std::normal_distribution<double> noise(0.0, d.noise);
  const Eigen::Vector2d back = -d.direction(), across(-back.y(), back.x());
  for (int y = 0; y < NeedlePicture::kHeight_px; ++y) {
    for (int x = 0; x < NeedlePicture::kWidth_px; ++x) {
      const Eigen::Vector2d from = Eigen::Vector2d(x, y) - d.tip;
      const double s = from.dot(back), v = std::abs(from.dot(across));
      const double tapered = std::min(s, d.tapered_px);
      const double side = v - d.tip_radius - d.slope * std::max(0.0, tapered);
      const double distance = d.straight         ? (side > 0.0 && s < 0.0 ? std::hypot(side, s) : std::max(side, -s))
                              : s < d.tip_radius ? std::hypot(s - d.tip_radius, v) - d.tip_radius
                                                 : v - d.tip_radius - d.slope * (tapered - d.tip_radius);
      double light = 0.55 + 0.0002 * x;
      light *= d.wedge ? 1.0 - 0.4 * 0.5 * std::erfc(distance / (d.blur * std::sqrt(2.0)))
                       : 1.0 - d.depth * std::exp(-0.5 * distance * distance / (d.blur * d.blur));
      if (d.membrane_ahead >= 0.0) {
        const double radius = d.membrane_radius;
        const double away = radius > 0.0 ? std::hypot(s + d.membrane_ahead + radius, v) - radius : s + d.membrane_ahead;
        light *= NeedleDrawing::membrane_light(away);
      }
      if (d.disc_behind_px >= 0.0)
        light *= 1.0 - 0.6 / (1.0 + std::exp(2.0 * (std::hypot(s - d.disc_behind_px, v) - d.disc_radius_px)));
      picture.pixels[static_cast<std::size_t>(y * NeedlePicture::kWidth_px + x)] =
          static_cast<std::uint8_t>(std::clamp(255.0 * (light + noise(random)) + 0.5, 0.0, 255.0));
    }
  }
  return picture;
}

/// The tool as voting would give it: a degree and two pixels off.
inline FoundTool tool_of(const NeedleDrawing& d) {
  FoundTool tool;
  tool.origin = d.tip + Eigen::Vector2d(-20.0, 5.0);
  const double angle = d.angle_rad + 0.015;
  tool.direction = {std::cos(angle), std::sin(angle)};
  const double offset = (d.tip - tool.origin).dot(Eigen::Vector2d(-tool.direction.y(), tool.direction.x())) + 1.5;
  tool.offset_from = offset - 10.0 - d.tip_radius - d.blur;
  tool.offset_to = offset + 10.0 + d.tip_radius + d.blur;
  return tool;
}

}  // namespace pellucida::test
