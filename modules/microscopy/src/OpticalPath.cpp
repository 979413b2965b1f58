#include "OpticalPath.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pellucida/microscopy/Strip.h"

namespace pellucida {
namespace {

const SoftRoot& soft_root() {
  static const SoftRoot root;
  return root;
}

// How far a pixel blurs an edge, um: a square's deviation is 0.29 of its side, and a little more hides its corners.
double pixel_blur_um(double pixel_size_um) {
  return 0.45 * pixel_size_um;
}

// A ramp from 0 to 1 as wide as a pixel.
float ramp(double distance_um, double blur_um) {
  return static_cast<float>(std::clamp(0.5 + distance_um / (3.4 * blur_um), 0.0, 1.0));
}

}  // namespace

SoftRoot::SoftRoot() {
  const int count = static_cast<int>((kHigh - kLow) * kSteps) + 2;
  for (int i = 0; i < count; ++i) {
    const double t = kLow + i / kSteps;
    double sum = 0, weight_sum = 0;
    for (double n = -5; n <= 5; n += 0.01) {
      const double weight = std::exp(-n * n / 2);
      sum += weight * std::sqrt(std::max(0.0, t + n));
      weight_sum += weight;
    }
    table_.push_back(static_cast<float>(sum / weight_sum));
  }
}

void OpticalPath::clear(const cv::Size& size) {
  for (cv::Mat1f* layer : {&phase_rad, &needle_phase_rad, &absorbance}) {
    layer->create(size);
    layer->setTo(0);
  }
}

void add_ball(OpticalPath& path, const SceneBall& ball, double pixel_size_um, double blur_um) {
  const SoftRoot& root = soft_root();
  const double blur = std::max(blur_um, pixel_blur_um(pixel_size_um)), reach = ball.radius_um + 3 * blur;
  const auto radius2 = static_cast<float>(ball.radius_um * ball.radius_um);
  // The chord's blur is uncertainty of r^2 at the rim; a ball smaller than it is spread out, with its volume kept.
  const auto deviation = static_cast<float>(2 * ball.radius_um * blur);
  const double small = blur / std::max(ball.radius_um, 1e-6), keep = 1 / (1 + small * small);
  const auto phase = static_cast<float>(2 * keep * kPhase_rad_per_um * ball.index),
             loss = static_cast<float>(2 * keep * ball.absorption_per_um);
  const Eigen::Vector2d center = ball.center_um / pixel_size_um;
  const double reach_px = reach / pixel_size_um;
  const int x0 = std::max(0, static_cast<int>(std::floor(center.x() - reach_px))),
            x1 = std::min(path.phase_rad.cols - 1, static_cast<int>(std::ceil(center.x() + reach_px)));
  const int y0 = std::max(0, static_cast<int>(std::floor(center.y() - reach_px))),
            y1 = std::min(path.phase_rad.rows - 1, static_cast<int>(std::ceil(center.y() + reach_px)));
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const float dx = static_cast<float>((x - center.x()) * pixel_size_um),
                  dy = static_cast<float>((y - center.y()) * pixel_size_um);
      const float half = root(radius2 - dx * dx - dy * dy, deviation);
      path.phase_rad(y, x) += phase * half;
      path.absorbance(y, x) += loss * half;
    }
}

void add_needle(OpticalPath& path, const MicroscopeScene& scene, double pixel_size_um) {
  if (!scene.needle) return;
  const SoftRoot& root = soft_root();
  const NeedleShape& shape = scene.needle_shape;
  const Eigen::Vector2d along = scene.needle->back, across(-along.y(), along.x());
  const double blur = pixel_blur_um(pixel_size_um), middle = shape.middle_um();
  const double reach = shape.shaft_radius_um + std::abs(middle) + 4 * blur;
  const Strip strip{scene.needle->end_um / pixel_size_um, along, across, reach / pixel_size_um,
                    -4 * blur / pixel_size_um};

  // The tube's radii by the place along it.
  const double step_um = std::max(0.1, 0.2 * pixel_size_um);
  const double from = -4 * blur, length = pixel_size_um * std::hypot(path.phase_rad.cols, path.phase_rad.rows) * 2;
  struct Slice {
    float outer2, lumen2, deviation, spike;
  };
  std::vector<Slice> slices;
  const bool closed = shape.look.end == "closed";
  const double r = shape.tip_radius_um;
  for (double back = from; back < length; back += step_um) {
    // Before its end the tube goes on, so that the cut alone ends it; a round tip's square goes below 0.
    const double outer = shape.outer_radius_um(closed ? back : std::max(back, shape.look.spike_um)),
                 lumen = shape.lumen_radius_um(closed ? back : std::max(back, 0.0));
    const double outer2 = closed && back < r ? r * r - (r - back) * (r - back) : outer * outer;
    slices.push_back({static_cast<float>(outer2), static_cast<float>(lumen * lumen),
                      static_cast<float>(2 * std::max(outer, 0.5 * r) * blur),
                      static_cast<float>(shape.spike_radius_um(back))});
  }
  const auto glass = static_cast<float>(2 * kPhase_rad_per_um * shape.look.index),
             liquid = static_cast<float>(2 * kPhase_rad_per_um * shape.look.liquid_index);
  const double end = shape.look.end == "bevelled" ? shape.look.spike_um : 0.0;
  for (int y = 0, first, last; y < path.needle_phase_rad.rows; ++y) {
    if (!strip.columns(y, path.needle_phase_rad.cols, first, last)) continue;
    float* phase = path.needle_phase_rad[y];
    for (int x = first; x <= last; ++x) {
      const Eigen::Vector2d place = pixel_size_um * (Eigen::Vector2d(x, y) - strip.origin);
      const double back = place.dot(along), lateral = place.dot(across);
      const auto i = std::min(slices.size() - 1, static_cast<std::size_t>(std::max(0.0, (back - from) / step_um)));
      const Slice& slice = slices[i];
      const auto side = static_cast<float>(lateral - middle);
      const float outer = root(slice.outer2 - side * side, slice.deviation);
      const float lumen = slice.lumen2 > 0 ? root(slice.lumen2 - side * side, slice.deviation) : 0.0f;
      float tube = glass * (outer - lumen) + liquid * lumen;
      if (!closed) tube *= ramp(std::min(back - end, shape.inside_cut_um(back, lateral)), blur);
      if (slice.spike > 0) {
        const auto from_spike = static_cast<float>(lateral) - slice.spike;
        const float spike = glass * root(slice.spike * slice.spike - from_spike * from_spike,
                                         static_cast<float>(2 * blur) * slice.spike);
        tube = std::max(tube, spike);
      }
      phase[x] += tube;
    }
  }
}

void add_holder(OpticalPath& path, const MicroscopeScene& scene, double glass_index, double pixel_size_um) {
  if (!scene.holder) return;
  const SoftRoot& root = soft_root();
  const HolderShape& shape = scene.holder_shape;
  const Eigen::Vector2d along = scene.holder->back, across(-along.y(), along.x());
  const double blur = pixel_blur_um(pixel_size_um);
  const double length = pixel_size_um * std::hypot(path.phase_rad.cols, path.phase_rad.rows);
  const double bend = std::abs(shape.middle_um(length)), reach = shape.outer_radius_um + std::min(bend, length);
  const Strip strip{scene.holder->end_um / pixel_size_um, along, across, reach / pixel_size_um + 4, -2};
  const auto deviation = static_cast<float>(2 * shape.outer_radius_um * blur);
  const auto glass = static_cast<float>(2 * kPhase_rad_per_um * glass_index);
  for (int y = 0, first, last; y < path.phase_rad.rows; ++y) {
    if (!strip.columns(y, path.phase_rad.cols, first, last)) continue;
    float* phase = path.phase_rad[y];
    for (int x = first; x <= last; ++x) {
      const Eigen::Vector2d place = pixel_size_um * (Eigen::Vector2d(x, y) - strip.origin);
      const double back = place.dot(along), half = shape.half_wall_um(back);
      if (half <= 0) continue;
      const auto side = static_cast<float>(place.dot(across) - shape.middle_um(back));
      const auto outer = static_cast<float>(shape.ring_radius_um() + half),
                 inner = static_cast<float>(shape.ring_radius_um() - half);
      phase[x] += glass * (root(outer * outer - side * side, deviation) - root(inner * inner - side * side, deviation));
    }
  }
}

}  // namespace pellucida
