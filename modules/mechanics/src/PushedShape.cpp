#include "PushedShape.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// What a value must exceed, in standard deviations; what these are taken for before any frame, and at least.
constexpr double kOverNoise = 5.0;
constexpr double kNoiseBefore_um = 0.15, kLeastNoise_um = 0.02;
/// By this share of itself it lags behind the needle.
constexpr double kShapeLag_ratio = 0.07;
/// What the newest frame counts in the noise.
constexpr double kNewestNoise_ratio = 0.2;
/// Flanks go with this power of the needle's depth: 1.7 to 2.2 as it is drawn back in films of the specimens; with the
/// depth itself, or more, as it goes on.
constexpr double kPower = 2.0;
/// Of a tip's way, what is beyond so many standard deviations of its place is sure.
constexpr double kSureWay_sigmas = 1.5;
/// How the most of late fades, per frame, while the needle is drawn back.
constexpr double kFadeBack = 0.9;
/// A tip that was shallower than this makes no share.
constexpr double kShallowestTip_um = 1.0;

}  // namespace

PushedShape::PushedShape(const Nature& nature) noexcept
    : nature_(nature), variance_um2_(kNoiseBefore_um * kNoiseBefore_um) {}

void PushedShape::learn_noise(double value_um) noexcept {
  if (std::isnan(value_um)) return;
  // A second difference has six times the variance of one value.
  const double bend = value_um - 2.0 * last_um_ + before_last_um_;
  if (!std::isnan(bend)) variance_um2_ += kNewestNoise_ratio * (bend * bend / 6.0 - variance_um2_);
  before_last_um_ = last_um_;
  last_um_ = value_um;
}

void PushedShape::fade(double tip_um) noexcept {
  most_um_ *= tip_um < tip_at_most_um_ ? std::min(kFadeBack, nature_.fade_ratio) : nature_.fade_ratio;
}

void PushedShape::follow(double value_um, double tip_um) noexcept {
  if (!(value_um > most_um_)) return;
  most_um_ = value_um;
  tip_at_most_um_ = tip_um;
}

double PushedShape::noise_um() const noexcept {
  return std::max({kLeastNoise_um, least_noise_um_, std::sqrt(variance_um2_)});
}

bool PushedShape::is_telling(double value_um) const noexcept {
  return value_um > std::max(nature_.least_um, kOverNoise * noise_um());
}

double PushedShape::expected_um(double tip_um, double tip_sigma_um) const noexcept {
  const double then = std::max(tip_at_most_um_, kShallowestTip_um), unsure = kSureWay_sigmas * tip_sigma_um;
  const double back = std::clamp((tip_um + unsure) / then, 0.0, 1.0);
  const double onward = std::clamp((tip_um - unsure) / then, 1.0, nature_.most_onward_ratio);
  return most_um_ * std::pow(back, kPower) * onward;
}

PushedShape::Share PushedShape::back(double value_um, double tip_um, double tip_sigma_um) const noexcept {
  const double expected = expected_um(tip_um, tip_sigma_um);
  if (std::isnan(value_um) || !is_telling(expected)) return {};
  return {std::max(0.0, 1.0 - value_um / expected), std::hypot(noise_um() / expected, kShapeLag_ratio)};
}

}  // namespace pellucida
