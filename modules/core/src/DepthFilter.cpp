#include "pellucida/core/DepthFilter.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// Of the motions "on as before" and "changing": spectral density of the needle's acceleration, um^2/s^3. A steady
/// needle changes its speed by a few um/s within a second, one that starts or halts by some 25 um/s within a frame. And
/// how likely each goes on from one frame to the next. Set on 62 tuning and wide films (303001 to 303040, 307001 to
/// 307040; docs/method.md, 3.8).
constexpr std::array kAccelerationDensity = {20.0, 2e4};
constexpr std::array kGoesOn = {0.95, 0.5};
/// Speeds a needle may have at first sight, um/s.
constexpr double kSpeedSpread_um_per_s = 40.0;
/// Frames farther apart than this have nothing to do with each other.
constexpr double kLongestFrameGap_s = 0.5;
/// No motion is less likely than this.
constexpr double kLeastShare = 1e-6;

}  // namespace

DepthFilter::Motion DepthFilter::mean_of(const Motions& motions) {
  const double sum = motions[0].share + motions[1].share;
  Motion mean{.share = sum};
  for (const Motion& one : motions) mean.state += one.share / sum * one.state;
  mean.covariance.setZero();
  for (const Motion& one : motions) {
    const Eigen::Vector2d off = one.state - mean.state;
    mean.covariance += one.share / sum * (one.covariance + off * off.transpose());
  }
  return mean;
}

std::optional<double> DepthFilter::expected_um(double time_s) const {
  const double dt_s = time_s_ ? time_s - *time_s_ : -1.0;
  if (dt_s < 0.0 || dt_s > kLongestFrameGap_s) return std::nullopt;
  const Motion now = mean_of(motions_);
  return now.state.x() + dt_s * now.state.y();
}

// Each motion begins where the needle is if that is what it does from now on.
void DepthFilter::interact() {
  const Motions before = motions_;
  for (std::size_t to = 0; to < motions_.size(); ++to) {
    Motions into = before;
    for (std::size_t from = 0; from < into.size(); ++from)
      into[from].share *= from == to ? kGoesOn[from] : 1.0 - kGoesOn[from];
    motions_[to] = mean_of(into);
  }
}

DepthFilter::Estimate DepthFilter::update(double time_s, double depth_um, double sigma_um) {
  const double variance = sigma_um * sigma_um;
  const double dt_s = time_s_ ? time_s - *time_s_ : -1.0;
  time_s_ = time_s;

  // First frame, a long gap, or time going back: begin anew.
  if (dt_s < 0.0 || dt_s > kLongestFrameGap_s) {
    const Eigen::Vector2d spread(variance, kSpeedSpread_um_per_s * kSpeedSpread_um_per_s);
    motions_.fill({.state = {depth_um, 0.0}, .covariance = spread.asDiagonal()});
    return {std::max(0.0, depth_um), sigma_um};
  }

  Eigen::Matrix2d step, noise;
  step << 1.0, dt_s, 0.0, 1.0;
  noise << dt_s * dt_s * dt_s / 3.0, dt_s * dt_s / 2.0, dt_s * dt_s / 2.0, dt_s;
  interact();
  std::array<double, 2> log_likelihood{};
  for (std::size_t k = 0; k < motions_.size(); ++k) {
    Motion& motion = motions_[k];
    motion.state = step * motion.state;
    motion.covariance = step * motion.covariance * step.transpose() + kAccelerationDensity[k] * noise;
    const double innovation = depth_um - motion.state.x(), expected = motion.covariance(0, 0) + variance;
    log_likelihood[k] = -0.5 * (innovation * innovation / expected + std::log(expected));
    const Eigen::Vector2d gain = motion.covariance.col(0) / expected;
    motion.state += gain * innovation;
    motion.covariance -= gain * motion.covariance.row(0).eval();
  }
  const double best = std::max(log_likelihood[0], log_likelihood[1]);
  for (std::size_t k = 0; k < motions_.size(); ++k) motions_[k].share *= std::exp(log_likelihood[k] - best);
  const double sum = motions_[0].share + motions_[1].share;
  for (Motion& motion : motions_) motion.share = std::max(kLeastShare, motion.share / sum);
  const Motion now = mean_of(motions_);
  return {std::max(0.0, now.state.x()), std::sqrt(std::max(0.0, now.covariance(0, 0)))};
}

}  // namespace pellucida
