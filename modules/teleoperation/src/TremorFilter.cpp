#include "pellucida/teleoperation/TremorFilter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

constexpr double kMeanSpeedCutoff_Hz = 1.0;       // well below tremor, so that tremor does not open the filter
constexpr double kDamping = std::numbers::sqrt2;  // Butterworth: 1 / Q
constexpr double kMaxCutoffTimesStep = 0.4;       // below Nyquist's 0.5, where the tangent runs away

}  // namespace

void TremorFilter::reset(const Eigen::Vector3d& position_m) noexcept {
  if (!position_m.allFinite()) return;
  input_m_ = low_ = position_m_ = position_m;
  band_.setZero();
  mean_velocity_m_per_s_.setZero();
  velocity_m_per_s_.setZero();
  cutoff_Hz_ = options_.rest_cutoff_Hz;
}

void TremorFilter::update(const Eigen::Vector3d& position_m, double dt_s) noexcept {
  if (!(dt_s > 0.0) || !std::isfinite(dt_s) || !position_m.allFinite()) return;
  const Eigen::Vector3d raw_velocity_m_per_s = (position_m - input_m_) / dt_s;
  input_m_ = position_m;
  if (!options_.enabled) {
    position_m_ = low_ = position_m;
    velocity_m_per_s_ = raw_velocity_m_per_s;
    return;
  }
  // The cut-off of this step, from the mean speed.
  const double blend = 1.0 - std::exp(-2.0 * std::numbers::pi * kMeanSpeedCutoff_Hz * dt_s);
  mean_velocity_m_per_s_ += blend * (raw_velocity_m_per_s - mean_velocity_m_per_s_);
  const double wished_Hz = options_.rest_cutoff_Hz + options_.cutoff_rise_Hz_s_per_m * mean_velocity_m_per_s_.norm();
  cutoff_Hz_ = std::min({wished_Hz, options_.max_cutoff_Hz, kMaxCutoffTimesStep / dt_s});

  // Two trapezoidal integrators in a loop: the state-variable form of the second-order low-pass.
  const double g = std::tan(std::numbers::pi * cutoff_Hz_ * dt_s);
  const double a1 = 1.0 / (1.0 + g * (g + kDamping));
  const Eigen::Vector3d difference = position_m - low_;
  const Eigen::Vector3d band_out = a1 * (band_ + g * difference);
  const Eigen::Vector3d low_out = low_ + g * band_out;
  band_ = 2.0 * band_out - band_;
  low_ = 2.0 * low_out - low_;
  position_m_ = low_out;
  velocity_m_per_s_ = band_out * (2.0 * g / dt_s);
}

double TremorFilter::lag_s() const noexcept {
  return options_.enabled ? kDamping / (2.0 * std::numbers::pi * cutoff_Hz_) : 0.0;
}

}  // namespace pellucida
