#include "pellucida/membrane/Indenter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/SolidForce.h"

namespace pellucida {
namespace {

/// No single step of the needle is longer; farther depths are reached in several.
constexpr double kLongestStep_um = 2.0;
/// The tangent's change with depth is taken over no shorter way, and trusted over no longer one.
constexpr double kShortestBend_um = 0.02;
constexpr double kLongestBentStep_um = 1.0;
/// A step that fails is halved down to this.
constexpr double kShortestStep_um = 0.05;
/// Differences along the tangent are taken over this depth.
constexpr double kProbe_um = 1e-3;
/// No single call spends more iterations: from rest to the deepest point takes about a hundred.
constexpr int kMostStepIterations = 400;
/// Up to this depth the force goes with the depth alone.
constexpr double kTouch_um = 1e-3;

}  // namespace

Indenter::Indenter(const CellProfile& profile, const MembraneSetup& setup)
    : model_(profile, setup), solver_(model_.energy()) {
  reset();
}

Indenter::Indenter(const CellProfile& profile, const MembraneGeometry& geometry, const Eigen::Vector3d& push,
                   const Eigen::Vector3d& holder)
    : kind_(profile),
      geometry_(geometry),
      model_(adapted_to(profile, geometry), {geometry.mid_radius_um, geometry.thickness_um, push, holder}),
      solver_(model_.energy()) {
  if (auto solid = SolidForce::of(profile, geometry)) solid_ = std::make_shared<SolidForce>(*std::move(solid));
  reset();
}

double Indenter::solid_share() const noexcept {
  return solid_ ? solid_->share(model_.setup()) : 0.0;
}

GeometryFactor Indenter::factor() const noexcept {
  if (!kind_) return {};
  const GeometryFactor springs = geometry_factor(*kind_, geometry_, depth_um_);
  const double share = solid_share();
  // Nothing was solved yet, or no force is to be scaled.
  const bool touches = depth_um_ > kTouch_um;
  const double push_uN = touches ? forces_.push_uN : kTouch_um * stiffness_uN_per_um_;
  if (share == 0.0 || !(push_uN > 0.0)) return springs;
  const SolidForce::LogForce solid = solid_->at(touches ? depth_um_ : kTouch_um);
  GeometryFactor both;
  both.ratio = std::pow(springs.ratio, 1.0 - share) * std::pow(std::exp(solid.log_uN) / push_uN, share);
  if (!touches) return both;
  const double by_solid = solid.by_depth_per_um - stiffness_uN_per_um_ / push_uN;
  both.slope_per_um = both.ratio * ((1.0 - share) * springs.slope_per_um / springs.ratio + share * by_solid);
  return both;
}

double Indenter::pressure_ratio() const noexcept {
  return kind_ ? pressure_factor(*kind_, geometry_, depth_um_) : 1.0;
}

void Indenter::observe(std::vector<NormalObservationTerm::Observed> observed) {
  if (!observes_) model_.energy().add_term(observation_);
  observes_ = true;
  observation_.set(std::move(observed));
}

void Indenter::reset() {
  if (observes_) observation_.set({});
  x_um_ = model_.rest().points_um;
  depth_um_ = 0.0;
  tangent_ = Eigen::Matrix3Xd::Zero(3, x_um_.cols());
  forces_ = {.volume_um3 = model_.volume().rest_volume_um3()};
  forget_elastic();
  stiffness_uN_per_um_ = 0.0;
  has_tangent_ = false;
  has_bend_ = false;
}

SolveReport Indenter::step_to(double depth_um) {
  // Start along the tangent, bent as it bent before, and keep the old shape for the case that it leads nowhere.
  const double step_um = depth_um - depth_um_;
  before_um_ = x_um_;
  x_um_ += step_um * tangent_;
  if (has_bend_ && std::abs(step_um) <= kLongestBentStep_um) x_um_ += (0.5 * step_um * step_um) * bend_per_um_;
  model_.set_depth(depth_um);
  SolveReport report = solver_.solve(x_um_, options_);
  if (report.status != SolveStatus::kConverged) {
    x_um_ = before_um_;
    model_.set_depth(depth_um_);
    return report;
  }
  depth_um_ = depth_um;

  // The gradient depends on the depth through the tip's bond alone: H dx/dd = w_i push. The force follows the depth by
  // sum_i w_i - (w push) . H^-1 (w push).
  load_uN_per_um_.setZero(3, x_um_.cols());
  double bond_uN_per_um = 0.0;
  for (std::size_t k = 0; k < model_.tip().nodes().size(); ++k) {
    const double weight = model_.tip().weights_uN_per_um()[k];
    load_uN_per_um_.col(model_.tip().nodes()[k]) = weight * model_.setup().push;
    bond_uN_per_um += weight;
  }
  LinearResponse response =
      solver_.respond(x_um_, load_uN_per_um_, has_bend_ ? tangent_ + step_um * bend_per_um_ : tangent_);
  stiffness_uN_per_um_ = bond_uN_per_um - response.compliance;
  if (has_tangent_ && std::abs(step_um) >= kShortestBend_um) {
    bend_per_um_ = (response.displacement - tangent_) / step_um;
    has_bend_ = true;
  }
  tangent_.swap(response.displacement);
  has_tangent_ = true;
  return report;
}

IndentationState Indenter::advance_to(double depth_um) {
  // Long ways in steps; a step that fails is tried shorter.
  SolveReport total;
  double step = kLongestStep_um;
  do {
    const double way = depth_um - depth_um_;
    const double target = std::abs(way) <= step ? depth_um : depth_um_ + std::copysign(step, way);
    const SolveReport report = step_to(target);
    total.status = report.status;
    total.iterations += report.iterations;
    total.conjugate_gradient_iterations += report.conjugate_gradient_iterations;
    total.factorizations += report.factorizations;
    total.shifts += report.shifts;
    total.residual_uN = report.residual_uN;
    if (total.iterations >= kMostStepIterations && depth_um_ != depth_um) {
      total.status = SolveStatus::kIterationBudget;
      break;
    }
    if (report.status != SolveStatus::kConverged) {
      step = 0.5 * std::min(step, std::abs(way));
      if (step < kShortestStep_um) break;
    }
  } while (depth_um_ != depth_um);

  forces_ = forces_at(x_um_);
  forget_elastic();
  return read_out(total);
}

SolvedShape Indenter::shape(const SolveReport& report) const {
  return {.depth_um = depth_um_,
          .positions_um = x_um_,
          .depth_tangent = tangent_,
          .elastic_slope_uN_per_um = elastic_slope_uN_per_um(),
          .elastic_force_uN = elastic_force_uN(),
          .forces = forces_,
          .stiffness_uN_per_um = stiffness_uN_per_um_,
          .force_scale_uN_per_um = model_.force_scale_uN_per_um(),
          .report = report};
}

IndentationState Indenter::adopt(const SolvedShape& solved) {
  depth_um_ = solved.depth_um;
  model_.set_depth(depth_um_);
  x_um_ = solved.positions_um;
  tangent_ = solved.depth_tangent;
  const double ratio = model_.force_scale_uN_per_um() / solved.force_scale_uN_per_um;
  forces_ = solved.forces;
  for (Eigen::Vector3d* force : {&forces_.tip_uN, &forces_.holder_uN}) *force *= ratio;
  forces_.push_uN *= ratio;
  forces_.pressure_Pa *= ratio;
  stiffness_uN_per_um_ = ratio * solved.stiffness_uN_per_um;
  forget_elastic();
  elastic_slope_uN_per_um_ = ratio * solved.elastic_slope_uN_per_um;
  elastic_uN_ = ratio * solved.elastic_force_uN;
  has_tangent_ = true;
  has_bend_ = false;
  return read_out(solved.report);
}

IndentationState Indenter::adopt_checked(const SolvedShape& solved, double tolerance_um) {
  const IndentationState state = adopt(solved);
  const Eigen::Matrix3Xd residual_uN = model_.residual_uN(x_um_, elastic_force_uN());
  const double largest_uN = std::sqrt(residual_uN.colwise().squaredNorm().maxCoeff());
  return largest_uN <= tolerance_um * model_.force_scale_uN_per_um() ? state : advance_to(solved.depth_um);
}

void Indenter::forget_elastic() {
  elastic_uN_.resize(3, 0);
  elastic_slope_uN_per_um_.resize(3, 0);
}

const Eigen::Matrix3Xd& Indenter::elastic_force_uN() const {
  if (elastic_uN_.cols() == 0) elastic_uN_ = model_.elastic_force_uN(x_um_);
  return elastic_uN_;
}

const Eigen::Matrix3Xd& Indenter::elastic_slope_uN_per_um() const {
  if (elastic_slope_uN_per_um_.cols() == 0) {
    elastic_slope_uN_per_um_ = (model_.elastic_force_uN(x_um_ + kProbe_um * tangent_) - elastic_force_uN()) / kProbe_um;
  }
  return elastic_slope_uN_per_um_;
}

ToolForces Indenter::force_slopes() {
  // The equilibrium moves along the tangent; the stiffness is more exact than a difference.
  model_.set_depth(depth_um_ + kProbe_um);
  const ToolForces ahead = forces_at(x_um_ + kProbe_um * tangent_);
  model_.set_depth(depth_um_);
  return {.tip_uN = (ahead.tip_uN - forces_.tip_uN) / kProbe_um,
          .holder_uN = (ahead.holder_uN - forces_.holder_uN) / kProbe_um,
          .push_uN = stiffness_uN_per_um_,
          .pressure_Pa = (ahead.pressure_Pa - forces_.pressure_Pa) / kProbe_um,
          .volume_um3 = (ahead.volume_um3 - forces_.volume_um3) / kProbe_um};
}

ToolForces Indenter::forces_at(const Eigen::Matrix3Xd& x_um) const {
  ToolForces forces;
  forces.tip_uN = model_.tip().force_uN(x_um);
  forces.holder_uN = model_.holder().force_uN(x_um);
  forces.push_uN = forces.tip_uN.dot(model_.setup().push);
  if (model_.setup().keeps_volume) forces.pressure_Pa = 1e6 * model_.volume().pressure_uN_per_um2(x_um) + 0.0;  // no -0
  forces.volume_um3 = model_.volume().volume_um3(x_um);
  return forces;
}

IndentationState Indenter::read_out(const SolveReport& report) const {
  const GeometryFactor factor = this->factor();
  IndentationState state;
  state.depth_um = depth_um_;
  state.tip_force_uN = factor.ratio * forces_.tip_uN;
  state.holder_force_uN = factor.ratio * forces_.holder_uN;
  state.push_force_uN = factor.ratio * forces_.push_uN;
  state.stiffness_uN_per_um = factor.ratio * stiffness_uN_per_um_ + factor.slope_per_um * forces_.push_uN;
  state.pressure_Pa = pressure_ratio() * forces_.pressure_Pa;
  state.volume_um3 = forces_.volume_um3;
  state.report = report;
  return state;
}

std::vector<IndentationState> force_curve(const CellProfile& profile, int configuration, double max_indentation_um,
                                          double step_um) {
  return force_curve(profile, geometry_of(profile), setup_for_configuration(profile, configuration), max_indentation_um,
                     step_um);
}

namespace {

std::vector<IndentationState> curve_of(Indenter& indenter, double max_indentation_um, double step_um) {
  const double deepest_um = 1.4 * indenter.model().setup().mid_radius_um;
  if (!(step_um > 0.0)) throw UsageError("step: it must be above 0 um");
  if (!(max_indentation_um > 0.0) || max_indentation_um > deepest_um) {
    throw UsageError("maximum indentation: it must be above 0 and at most 1.4 radii of the cell, " +
                     std::to_string(deepest_um) + " um");
  }
  std::vector<IndentationState> curve;
  const int steps = static_cast<int>(std::floor(max_indentation_um / step_um + 1e-9));
  for (int k = 0; k <= steps; ++k) curve.push_back(indenter.advance_to(k * step_um));
  if (max_indentation_um - steps * step_um > 1e-9) curve.push_back(indenter.advance_to(max_indentation_um));
  return curve;
}

}  // namespace

std::vector<IndentationState> force_curve(const CellProfile& profile, const MembraneSetup& setup,
                                          double max_indentation_um, double step_um) {
  Indenter indenter(profile, setup);
  return curve_of(indenter, max_indentation_um, step_um);
}

std::vector<IndentationState> force_curve(const CellProfile& profile, const MembraneGeometry& geometry,
                                          const MembraneSetup& setup, double max_indentation_um, double step_um) {
  Indenter indenter(profile, geometry, setup.push, setup.holder);
  return curve_of(indenter, max_indentation_um, step_um);
}

}  // namespace pellucida
