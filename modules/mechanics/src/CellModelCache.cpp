#include "CellModelCache.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pellucida/mechanics/ExpectedPuncture.h"
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
/// A model that has served so many frames before the contact is worth a path.
constexpr int kSteadyFrames = 5;
/// A shape read off the path is in equilibrium when no node's residual force is above this times E h.
constexpr double kPathTolerance_um = 1e-3;
/// How deep the risk of puncture is reported, in the indentations at which a puncture is expected.
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
    forget_path();
    has_turned_ = false;
    built_ = seen;
    indenter_ = std::make_unique<Indenter>(profile_, built_, placement.push(), placement.holder());
    rest_stiffness_uN_per_um_ = indenter_->advance_to(0.0).stiffness_uN_per_um;
    offset_um_ = placement.offset_um();
    outer_radius_um_ = built_.mid_radius_um + 0.5 * built_.thickness_um;
  } else if (model().setup().holder.dot(placement.holder()) < std::cos(kHolderTurn_rad)) {
    indenter_->set_holder(placement.holder());
    forget_path();
    has_turned_ = o.state != CellState::kFree;
  }
  if (o.state == CellState::kFree) {
    has_turned_ = false;
    if (!path_ && ++steady_frames_ >= kSteadyFrames) start_path();
  }
  return !fits;
}

void CellModelCache::forget_path() {
  path_.reset();
  deepest_.reset();
  steady_frames_ = 0;
}

void CellModelCache::set_deepest(std::optional<SolvedShape> shape) {
  deepest_ = std::move(shape);
  if (deepest_) deepest_->report = {.status = deepest_->report.status};  // what it took is spent once
}

void CellModelCache::start_path() {
  const MembraneSetup& setup = model().setup();
  path_ = std::make_unique<EquilibriumPath>(profile_, built_, setup.push, setup.holder);
}

IndentationState CellModelCache::press(double depth_um, const SolvedShape* known) {
  if (known && known->depth_um == depth_um && known->report.status == SolveStatus::kConverged &&
      known->positions_um.cols() == model().rest().points_um.cols()) {
    start_anew_ = false;
    return indenter_->adopt(*known);
  }
  if (!has_turned_) {
    if (!path_) start_path();
    if (const auto shape = path_->at(depth_um)) {
      start_anew_ = false;
      return indenter_->adopt_checked(*shape, kPathTolerance_um);
    }
    if (!deepest_) set_deepest(path_->end());
  }
  return press_solved(depth_um);
}

IndentationState CellModelCache::press_solved(double depth_um) {
  if (deepest_ && depth_um > deepest_->depth_um) {
    start_anew_ = false;
    return indenter_->adopt(*deepest_);
  }
  const bool from_rest = start_anew_;
  if (from_rest) indenter_->reset();
  const IndentationState state = indenter_->advance_to(depth_um);
  const bool is_solved = state.report.status == SolveStatus::kConverged;
  if (!is_solved && from_rest) set_deepest(indenter_->shape(state.report));
  start_anew_ = !is_solved && !from_rest;
  return state;
}

IndentationState CellModelCache::release() {
  indenter_->reset();
  IndentationState state;
  state.volume_um3 = model().volume().rest_volume_um3();
  return state;
}

std::optional<CellModelCache::PushModel> CellModelCache::model_of(const Palpation& push) {
  const double depth_um = std::min(push.indentation_um, deepest_um());
  const bool by_force = push.known_force_uN > 0.0;
  indenter_->reset();
  const IndentationState before = indenter_->advance_to(std::max(0.0, depth_um - kSlopeStep_um));
  const IndentationState at = indenter_->advance_to(depth_um);
  indenter_->reset();
  if (at.report.status != SolveStatus::kConverged || !(at.push_force_uN > 0.0)) return std::nullopt;
  ForceErrors model;
  add_model_errors(profile_, at.push_force_uN, rest_stiffness_uN_per_um_, model);
  PushModel result;
  result.sigma_ratio = std::hypot(model.model_ratio, model.model_uN / at.push_force_uN);
  result.value = by_force ? at.push_force_uN : at.stiffness_uN_per_um;
  result.slope_per_um =
      by_force ? at.stiffness_uN_per_um : (at.stiffness_uN_per_um - before.stiffness_uN_per_um) / kSlopeStep_um;
  return result;
}

std::optional<CellScale> CellModelCache::scale_after(std::span<const ScaleMeasurement> measurements) {
  struct Push {
    double ratio, variance, depth_um;
  };
  std::vector<Push> pushes, moduli;
  double model_sigma = 0.0;
  for (const ScaleMeasurement& measurement : measurements) {
    if (way_of(measurement) == ScaleWay::kAspiration) {
      const double ratio =
          measurement.modulus_kPa / (measurement.modulus_of_profile_ratio * profile_.effective_young_modulus_kPa);
      moduli.push_back({ratio, std::pow(0.01 * measurement.modulus_sigma_percent, 2), 0.0});
      continue;
    }
    const Palpation push = push_of(measurement);
    const auto model = model_of(push);
    if (!model) return std::nullopt;
    const double by_depth = model->slope_per_um * push.indentation_sigma_um / model->value;
    pushes.push_back({std::max(push.known_force_uN, push.known_stiffness_uN_per_um) / model->value,
                      push.relative_sigma * push.relative_sigma + by_depth * by_depth, push.indentation_um});
    model_sigma = std::max(model_sigma, model->sigma_ratio);
  }
  ScaleEstimate estimate(scale_before(profile_), geometry_.force_sigma_ratio(), model_sigma);
  for (const Push& push : pushes) estimate.add_push(push.ratio, push.variance);
  for (const Push& modulus : moduli) estimate.add_modulus(modulus.ratio, modulus.variance);
  CellScale scale = estimate.result();
  double weights = 0.0;
  for (const Push& push : pushes) {
    weights += 1.0 / push.variance;
    scale.push_depth_um += (push.depth_um - scale.push_depth_um) / push.variance / weights;
  }
  return scale;
}

std::vector<PunctureRisk> CellModelCache::puncture_risk(double step_um, const CellScale& scale) {
  std::vector<PunctureRisk> risk;
  const ExpectedPuncture expected = expected_puncture(profile_, built_, scale.ratio);
  indenter_->reset();
  for (int k = 1; k * step_um <= kRiskDepth_ratio * expected.depth_um; ++k) {
    const IndentationState state = indenter_->advance_to(k * step_um);
    if (state.report.status != SolveStatus::kConverged) break;
    ForceErrors errors;
    add_model_errors(profile_, state.push_force_uN, rest_stiffness_uN_per_um_, errors);
    const double force_uN = scale.ratio * state.push_force_uN;
    const double relative = std::hypot(errors.model_ratio, scale.relative_sigma);
    risk.push_back({k * step_um, force_uN, puncture_probability(expected, force_uN, relative)});
  }
  indenter_->reset();
  return risk;
}

}  // namespace pellucida
