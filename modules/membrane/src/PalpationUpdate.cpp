#include "pellucida/membrane/PalpationUpdate.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core/Error.h"

namespace pellucida {

void validate(const Palpation& palpation) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (positive(palpation.known_force_uN) == positive(palpation.known_stiffness_uN_per_um)) {
    throw UsageError("palpation: give a known force or a known stiffness above 0, one of the two");
  }
  if (!positive(palpation.indentation_um)) throw UsageError("palpation: its indentation must be above 0 um");
  if (!(palpation.indentation_sigma_um >= 0.0)) throw UsageError("palpation: the depth's sigma must be 0 um or above");
  if (!positive(palpation.relative_sigma)) {
    throw UsageError("palpation: the known value's sigma must be above 0 %");
  }
}

CellScale scale_before(const CellProfile& profile) noexcept {
  return {1.0, std::hypot(profile.force_scale_relative_sigma, profile.kind_spread_ratio)};
}

CellScale update_scale(const CellScale& before, const Palpation& palpation, double model_value,
                       double model_slope_per_um, double model_relative_sigma) noexcept {
  const double known = std::max(palpation.known_force_uN, palpation.known_stiffness_uN_per_um);
  const double measured = std::log(known / model_value);
  const double by_depth = model_slope_per_um * palpation.indentation_sigma_um / model_value;
  const double variance = palpation.relative_sigma * palpation.relative_sigma + by_depth * by_depth +
                          model_relative_sigma * model_relative_sigma;
  const double before_variance = before.relative_sigma * before.relative_sigma;
  // A scale that is known exactly learns nothing.
  if (!(before_variance > 0.0)) return before;
  const double after_variance = 1.0 / (1.0 / before_variance + 1.0 / variance);
  const double mean = after_variance * (std::log(before.ratio) / before_variance + measured / variance);
  return {std::exp(mean), std::sqrt(after_variance)};
}

}  // namespace pellucida
