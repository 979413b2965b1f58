#pragma once
#include <opencv2/core.hpp>
#include <vector>

#include "pellucida/microscopy/MicroscopeScene.h"

namespace pellucida {

/// Radians of phase for a micrometre of thickness and a unit of index: 2 pi / 0.55 um.
inline constexpr double kPhase_rad_per_um = 11.42397;

/// The root of u where u > 0, else 0, for a u that is uncertain by a deviation: E[sqrt(max(u + n, 0))]. With the
/// deviation a pixel brings about, half chords of round bodies have no stairs.
class SoftRoot {
 public:
  SoftRoot();
  float operator()(float u, float deviation) const noexcept {
    const float t = u / deviation;
    if (t <= kLow) return 0.0f;
    const float root = std::sqrt(deviation);
    if (t >= kHigh) return root * std::sqrt(t);
    const float place = (t - kLow) * kSteps;
    const auto i = static_cast<std::size_t>(place);
    return root * (table_[i] + (place - static_cast<float>(i)) * (table_[i + 1] - table_[i]));
  }

 private:
  static constexpr float kLow = -4.0f, kHigh = 12.0f, kSteps = 64.0f;
  std::vector<float> table_;
};

/// What the light meets, pixel by pixel (CV_32F).
struct OpticalPath {
  cv::Mat1f phase_rad;         ///< of all but the needle
  cv::Mat1f needle_phase_rad;  ///< of the needle, which may lie out of focus
  cv::Mat1f absorbance;        ///< natural logarithm of the loss

  void clear(const cv::Size& size);
};

/// Adds a ball's optical path. `blur_um`: of a ball out of focus, at least that of the pixels.
void add_ball(OpticalPath& path, const SceneBall& ball, double pixel_size_um, double blur_um = 0.0);

/// Adds the glass of the scene's tools, where they are.
void add_needle(OpticalPath& path, const MicroscopeScene& scene, double pixel_size_um);
void add_holder(OpticalPath& path, const MicroscopeScene& scene, double glass_index, double pixel_size_um);

}  // namespace pellucida
