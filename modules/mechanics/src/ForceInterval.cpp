#include "pellucida/mechanics/ForceInterval.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// No profile's error counts for more than this.
constexpr double kLargestErrorRatio = 0.6;

}  // namespace

double ForceErrors::absolute_uN() const noexcept {
  return std::hypot(std::hypot(depth_uN, shape_uN), std::hypot(model_uN, relaxation_uN));
}

double ForceErrors::relative() const noexcept {
  return std::hypot(std::hypot(model_ratio, scale_ratio), geometry_ratio);
}

ForceErrors ForceErrors::of_picture() const noexcept {
  ForceErrors errors = *this;
  errors.scale_ratio = 0.0;
  return errors;
}

ForceErrors ForceErrors::of_scale() const noexcept {
  ForceErrors errors;
  errors.scale_ratio = scale_ratio;
  return errors;
}

ForceInterval interval_95(double force_uN, const ForceErrors& errors) noexcept {
  const double absolute = kSigmas95 * errors.absolute_uN(), relative = kSigmas95 * errors.relative();
  const double upwards = std::hypot(relative, kSigmas95 * errors.stiffening_ratio);
  ForceInterval interval;
  interval.upper_uN = force_uN + std::hypot(force_uN * std::expm1(upwards), absolute);
  interval.lower_uN = std::max(0.0, force_uN - std::hypot(force_uN * -std::expm1(-relative), absolute));
  interval.sigma_uN = std::hypot(force_uN * errors.relative(), errors.absolute_uN());
  return interval;
}

void add_model_errors(const CellProfile& profile, double force_uN, double rest_stiffness_uN_per_um,
                      ForceErrors& errors) noexcept {
  double ratio = 0.0, floor_uN = 0.0;
  for (const ProfileError& error : profile.errors) {
    const double largest = std::min(error.largest_ratio, kLargestErrorRatio);
    // The model's force may be too small by that share of the true one.
    const double two_sigma = -std::log1p(-largest);
    const double peak_uN = error.largest_of_peak_ratio * profile.puncture_force_uN;
    const double from_uN = rest_stiffness_uN_per_um * error.from_um;
    if (force_uN >= from_uN) {
      ratio = std::max(ratio, std::min(two_sigma, force_uN > 0.0 ? peak_uN / force_uN : two_sigma));
    } else {
      floor_uN = std::max(floor_uN, std::min(two_sigma * from_uN, peak_uN));
    }
  }
  errors.model_ratio = 0.5 * ratio;
  errors.model_uN = 0.5 * floor_uN;
}

}  // namespace pellucida
