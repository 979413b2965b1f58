#include "pellucida/core/DepthFilter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// Spectral density of the needle's acceleration, um^2/s^3: a manipulator that changes speed by a few um/s within a
/// second.
constexpr double kAccelerationDensity = 20.0;
/// Speeds a needle may have at once when a new motion starts, um/s.
constexpr double kSpeedSpread_um_per_s = 40.0;
/// Frames farther apart than this have nothing to do with each other.
constexpr double kLongestFrameGap_s = 0.5;
/// Squared innovation over its variance beyond which the motion has changed.
constexpr double kGate = 9.0;

}  // namespace

std::optional<double> DepthFilter::expected_um(double time_s) const {
  const double dt_s = time_s_ ? time_s - *time_s_ : -1.0;
  if (dt_s < 0.0 || dt_s > kLongestFrameGap_s) return std::nullopt;
  return state_.x() + dt_s * state_.y();
}

DepthFilter::Estimate DepthFilter::update(double time_s, double depth_um, double sigma_um) {
  const double variance = sigma_um * sigma_um;
  const double dt_s = time_s_ ? time_s - *time_s_ : -1.0;

  // First frame, a long gap, or time going back: begin anew.
  if (dt_s < 0.0 || dt_s > kLongestFrameGap_s) {
    state_ = {depth_um, 0.0};
    covariance_ = Eigen::Vector2d(variance, kSpeedSpread_um_per_s * kSpeedSpread_um_per_s).asDiagonal();
    time_s_ = time_s;
    return {std::max(0.0, depth_um), sigma_um};
  }
  time_s_ = time_s;

  // Predict.
  Eigen::Matrix2d motion;
  motion << 1.0, dt_s, 0.0, 1.0;
  Eigen::Matrix2d noise;
  noise << dt_s * dt_s * dt_s / 3.0, dt_s * dt_s / 2.0, dt_s * dt_s / 2.0, dt_s;
  state_ = motion * state_;
  covariance_ = motion * covariance_ * motion.transpose() + kAccelerationDensity * noise;

  // A motion the prediction didn't expect: trust the measurement, and learn the speed anew.
  const double innovation = depth_um - state_.x();
  if (innovation * innovation > kGate * (covariance_(0, 0) + variance)) {
    const double spread = kSpeedSpread_um_per_s * kSpeedSpread_um_per_s;
    covariance_(0, 0) += spread * dt_s * dt_s + innovation * innovation;
    covariance_(1, 1) += spread;
    covariance_(0, 1) = covariance_(1, 0) = covariance_(0, 1) + spread * dt_s;
  }

  // Correct.
  const Eigen::Vector2d gain = covariance_.col(0) / (covariance_(0, 0) + variance);
  state_ += gain * innovation;
  covariance_ -= gain * covariance_.row(0).eval();
  return {std::max(0.0, state_.x()), std::sqrt(std::max(0.0, covariance_(0, 0)))};
}

}  // namespace pellucida
