#include "CellModelCache.h"

#include <algorithm>
#include <cmath>

#include "pellucida/mechanics/ForceInterval.h"

namespace pellucida {
namespace {

/// The model is built anew when the tracked rest radius moved by more than this share,
constexpr double kRebuildRatio = 0.004;
/// out of contact the thickness by this, a tool's radius by this (each moves the force by about a per cent),
constexpr double kThicknessStep_ratio = 0.01, kToolStep_ratio = 0.03;
/// or the needle's offset by this; a holder that turned by so much is followed.
constexpr double kOffsetStep_um = 0.75;
constexpr double kHolderTurn_rad = 0.002;
/// How deep the risk of puncture is reported, in puncture indentations.
constexpr double kRiskDepth_ratio = 1.3;
/// A stiffness' slope by depth is taken over this.
constexpr double kSlopeStep_um = 0.5;

}  // namespace

bool CellModelCache::fit(const Observation& o, const CellPlacement& placement) {
  geometry_.update(o);
  const MembraneGeometry& seen = geometry_.geometry();
  const auto holds = [&](double MembraneGeometry::*length, double ratio) {
    return std::abs(seen.*length / (built_.*length) - 1.0) < ratio;
  };
  bool fits = indenter_ && holds(&MembraneGeometry::mid_radius_um, kRebuildRatio) &&
              std::abs(placement.offset_um() - offset_um_) < kOffsetStep_um;
  if (fits && o.state == CellState::kFree) {
    fits = holds(&MembraneGeometry::thickness_um, kThicknessStep_ratio) &&
           holds(&MembraneGeometry::tip_radius_um, kToolStep_ratio) &&
           holds(&MembraneGeometry::holder_radius_um, kToolStep_ratio);
  }
  if (!fits) {
    built_ = seen;
    indenter_ = std::make_unique<Indenter>(profile_, built_, placement.push(), placement.holder());
    rest_stiffness_uN_per_um_ = indenter_->advance_to(0.0).stiffness_uN_per_um;
    offset_um_ = placement.offset_um();
    outer_radius_um_ = built_.mid_radius_um + 0.5 * built_.thickness_um;
  } else if (model().setup().holder.dot(placement.holder()) < std::cos(kHolderTurn_rad)) {
    indenter_->set_holder(placement.holder());
  }
  return !fits;
}

IndentationState CellModelCache::press(double depth_um, const SolvedShape* known) {
  if (known && known->depth_um == depth_um && known->report.status == SolveStatus::kConverged &&
      known->positions_um.cols() == model().rest().points_um.cols()) {
    start_anew_ = false;
    return indenter_->adopt(*known);
  }
  if (start_anew_) indenter_->reset();
  const IndentationState state = indenter_->advance_to(depth_um);
  start_anew_ = state.report.status != SolveStatus::kConverged;
  return state;
}

IndentationState CellModelCache::release() {
  indenter_->reset();
  IndentationState state;
  state.volume_um3 = model().volume().rest_volume_um3();
  return state;
}

std::optional<CellScale> CellModelCache::scale_after(const Palpation& palpation) {
  const double depth_um = std::min(palpation.indentation_um, deepest_um());
  const bool by_force = palpation.known_force_uN > 0.0;
  indenter_->reset();
  const IndentationState before = indenter_->advance_to(std::max(0.0, depth_um - kSlopeStep_um));
  const IndentationState at = indenter_->advance_to(depth_um);
  indenter_->reset();
  if (at.report.status != SolveStatus::kConverged || !(at.push_force_uN > 0.0)) return std::nullopt;
  ForceErrors model;
  add_model_errors(profile_, at.push_force_uN, rest_stiffness_uN_per_um_, model);
  const double relative = std::hypot(model.model_ratio, model.model_uN / at.push_force_uN);
  const double value = by_force ? at.push_force_uN : at.stiffness_uN_per_um;
  const double slope =
      by_force ? at.stiffness_uN_per_um : (at.stiffness_uN_per_um - before.stiffness_uN_per_um) / kSlopeStep_um;
  return update_scale(scale_before(profile_), palpation, value, slope, relative);
}

std::vector<PunctureRisk> CellModelCache::puncture_risk(double step_um, const CellScale& scale) {
  std::vector<PunctureRisk> risk;
  indenter_->reset();
  for (int k = 1; k * step_um <= kRiskDepth_ratio * profile_.puncture_indentation_um; ++k) {
    const IndentationState state = indenter_->advance_to(k * step_um);
    if (state.report.status != SolveStatus::kConverged) break;
    ForceErrors errors;
    add_model_errors(profile_, state.push_force_uN, rest_stiffness_uN_per_um_, errors);
    const double force_uN = scale.ratio * state.push_force_uN;
    const double relative = std::hypot(errors.model_ratio, scale.relative_sigma);
    risk.push_back({k * step_um, force_uN, puncture_probability(profile_, force_uN, relative)});
  }
  indenter_->reset();
  return risk;
}

}  // namespace pellucida
