#include "PushedShape.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// What a value must exceed, in standard deviations, and what these are at least.
constexpr double kOverNoise = 3.0;
constexpr double kLeastNoise_um = 0.15;
/// By this share of itself it lags behind the needle.
constexpr double kShapeLag_ratio = 0.07;
/// What the newest frame counts in the noise.
constexpr double kNewestNoise_ratio = 0.2;
/// Flanks go with this power of the needle's depth: 1.7 to 2.2 as it is drawn back in films of the specimens.
constexpr double kPower = 2.0;
/// Of a tip's way back, what is beyond so many standard deviations of its place is sure.
constexpr double kSureBack_sigmas = 1.5;
/// How the most of late fades, per frame.
constexpr double kMostFade = 0.9;
/// A tip that was shallower than this makes no share.
constexpr double kShallowestTip_um = 2.5;

}  // namespace

void PushedShape::learn_noise(double value_um) noexcept {
  if (std::isnan(value_um)) return;
  // Half of a squared difference is the variance of one.
  if (!std::isnan(last_um_))
    variance_um2_ += kNewestNoise_ratio * (0.5 * std::pow(value_um - last_um_, 2) - variance_um2_);
  last_um_ = value_um;
}

void PushedShape::fade() noexcept {
  most_um_ *= kMostFade;
}

void PushedShape::follow(double value_um, double tip_um) noexcept {
  if (!(value_um > most_um_)) return;
  most_um_ = value_um;
  tip_at_most_um_ = tip_um;
}

double PushedShape::noise_um() const noexcept {
  return std::max(kLeastNoise_um, std::sqrt(variance_um2_));
}

bool PushedShape::is_telling(double value_um) const noexcept {
  return value_um > std::max(least_um_, kOverNoise * noise_um());
}

double PushedShape::expected_um(double tip_um, double tip_sigma_um) const noexcept {
  const double kept =
      std::clamp((tip_um + kSureBack_sigmas * tip_sigma_um) / std::max(tip_at_most_um_, kShallowestTip_um), 0.0, 1.0);
  return most_um_ * std::pow(kept, kPower);
}

PushedShape::Share PushedShape::back(double value_um, double tip_um, double tip_sigma_um) const noexcept {
  const double expected = expected_um(tip_um, tip_sigma_um);
  if (std::isnan(value_um) || !is_telling(expected)) return {};
  return {std::max(0.0, 1.0 - value_um / expected), std::hypot(noise_um() / expected, kShapeLag_ratio)};
}

}  // namespace pellucida
