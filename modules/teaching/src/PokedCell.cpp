#include "pellucida/teaching/PokedCell.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr double kFarthestOut_um = 50.0;
constexpr double kFarthestAcross_um = 12.0;
constexpr double kFastestTip_um_per_s = 150.0;
// The tip follows the hand within about this time.
constexpr double kTipLag_s = 0.03;
constexpr double kStartOut_um = 10.0;
// Kinetic energy is never more than what was put in; the factor covers the strays of symplectic Euler near its limit.
constexpr double kMostEnergy_ratio = 10.0;
// So much more may be in motion that the shape shows it: a broken step is seen, not only reported.
constexpr double kEnergyFloor_um2 = 500.0;  // times E h
constexpr int kFirstLanczosSteps = 40;
constexpr int kNextLanczosSteps = 10;
// How often the energy supplied is brought down to what is left of it.
constexpr std::uint64_t kLedgerSteps = 64;

bool has_same_shape(const TeachingParameters& a, const TeachingParameters& b) {
  return a.profile == b.profile && a.mesh_frequency == b.mesh_frequency;
}
bool has_same_model(const TeachingParameters& a, const TeachingParameters& b) {
  return has_same_shape(a, b) && a.young_modulus_kPa == b.young_modulus_kPa && a.keeps_volume == b.keeps_volume;
}

std::unique_ptr<Integrator> integrator_of(IntegratorKind kind, const Dynamics& dynamics) {
  switch (kind) {
    case IntegratorKind::kSymplecticEuler:
      return make_symplectic_euler(dynamics);
    case IntegratorKind::kLinearAcceleration:
      return make_linear_acceleration(dynamics);
    case IntegratorKind::kImplicitEuler:
      break;
  }
  return make_implicit_euler(dynamics);
}

}  // namespace

PokedCell::PokedCell(const TeachingParameters& parameters) : parameters_(parameters) {
  require_valid(parameters);
  build();
  rest();
}

PokedCell::~PokedCell() = default;

void PokedCell::build() {
  integrator_.reset();
  profile_ = profile_of(parameters_);
  model_ = std::make_unique<MembraneModel>(profile_, setup_of(profile_, parameters_));
  mesh_ = std::make_shared<const CellMesh>(mesh_of(*model_, profile_));
}

void PokedCell::make_integrator() {
  integrator_.reset();
  kind_ = integrator_kind(parameters_.integrator);
  dynamics_.emplace(
      Dynamics{model_->energy(), model_->springs(), parameters_.node_mass_kg,
               parameters_.damping_ratio * critical_damping_uN_s_per_um(model_->springs(), parameters_.node_mass_kg)});
  integrator_ = integrator_of(kind_, *dynamics_);
  // A shape torn apart has no limit that would help.
  const Eigen::Matrix3Xd& shape_um = blow_up_ ? model_->rest().points_um : state_.x_um;
  stability_ = stability_solver_.solve(*dynamics_, shape_um, kind_, kFirstLanczosSteps);
}

void PokedCell::rest() {
  state_.x_um = model_->rest().points_um;
  state_.v_um_per_s.setZero(3, state_.x_um.cols());
  acceleration_um_per_s2_ = state_.v_um_per_s;
  model_->set_tip_displacement(Eigen::Vector3d::Zero());
  tip_along_um_ = std::min(tip_along_um_, 0.0);
  tip_across_um_ = 0.0;
  supplied_pJ_ = 0.0;
  time_s_ = 0.0;
  step_count_ = 0;
  blow_up_.reset();
  make_integrator();
}

void PokedCell::restart() {
  tip_along_um_ = std::min(hand_along_um_, 0.0);
  rest();
}

void PokedCell::set_parameters(const TeachingParameters& parameters) {
  require_valid(parameters);
  const TeachingParameters before = std::exchange(parameters_, parameters);
  const Eigen::Vector3d tip_um = tip_displacement_um();
  if (!has_same_model(before, parameters_)) build();
  if (!has_same_shape(before, parameters_)) {
    rest();
    return;
  }
  model_->set_tip_displacement(tip_um);
  make_integrator();
  // A harder cell of the same shape holds more energy.
  supplied_pJ_ = dynamics_->total_energy_uN_um(state_);
}

void PokedCell::set_hand(double along_um, double across_um) {
  hand_along_um_ = std::clamp(along_um, -kFarthestOut_um, mesh_->deepest_um);
  const double reach_um = std::clamp(hand_along_um_, 0.0, kFarthestAcross_um);
  hand_across_um_ = std::clamp(across_um, -reach_um, reach_um);
}

// The tip goes to where hand and force balance, first order in time and no faster than it may.
void PokedCell::move_tip(double dt_s) {
  const Eigen::Vector3d force_uN = model_->tip().force_uN(state_.x_um);
  const Eigen::Vector3d across = Eigen::Vector3d::UnitX();
  const double give = parameters_.hand_give_um_per_uN;
  const double follow = dt_s / (dt_s + kTipLag_s);
  const double reach_um = kFastestTip_um_per_s * dt_s;
  const auto moved = [&](double tip_um, double hand_um, double against_uN) {
    return tip_um + std::clamp(follow * (hand_um - give * against_uN - tip_um), -reach_um, reach_um);
  };
  tip_along_um_ = std::min(moved(tip_along_um_, hand_along_um_, tip_along_um_ > 0.0 ? force_uN.dot(mesh_->push) : 0.0),
                           mesh_->deepest_um);
  tip_across_um_ = moved(tip_across_um_, hand_across_um_, force_uN.dot(across));
  const double deep_um = std::max(tip_along_um_, 0.0);
  tip_across_um_ = std::clamp(tip_across_um_, -deep_um, deep_um);

  // What the needle adds is the bond's change while the nodes are where they are.
  const double bond_pJ = model_->tip().add(state_.x_um, nullptr, nullptr);
  model_->set_tip_displacement(deep_um * mesh_->push + tip_across_um_ * across);
  supplied_pJ_ += std::max(0.0, model_->tip().add(state_.x_um, nullptr, nullptr) - bond_pJ);
}

bool PokedCell::step() {
  if (blow_up_) return false;
  const double dt_s = 1e-6 * parameters_.time_step_us;
  before_ = state_;
  move_tip(dt_s);
  if (!integrator_->step(state_, dt_s)) {
    end_motion(kind_ == IntegratorKind::kSymplecticEuler ? BlowUpKind::kNotFinite : BlowUpKind::kNoSolution);
    return false;
  }
  if (!state_.x_um.allFinite() || !state_.v_um_per_s.allFinite()) {
    end_motion(BlowUpKind::kNotFinite);
    return false;
  }
  acceleration_um_per_s2_ = (state_.v_um_per_s - before_.v_um_per_s) / dt_s;
  time_s_ += dt_s;
  ++step_count_;
  check_energy();
  return !blow_up_;
}

void PokedCell::check_energy() {
  if (step_count_ % kLedgerSteps == 0) {
    supplied_pJ_ = std::min(supplied_pJ_, std::max(0.0, dynamics_->total_energy_uN_um(state_)));
  }
  const double floor_pJ = kEnergyFloor_um2 * model_->force_scale_uN_per_um();
  if (kinetic_energy_pJ() > kMostEnergy_ratio * supplied_pJ_ + floor_pJ) end_motion(BlowUpKind::kEnergyRanAway);
}

void PokedCell::end_motion(BlowUpKind kind) {
  const double kinetic_pJ = kinetic_energy_pJ();
  blow_up_ = BlowUp{kind, time_s_, 1e-6 * parameters_.time_step_us, stability_.stable_step_s, kinetic_pJ, supplied_pJ_};
  // The last shape that can be drawn.
  state_ = before_;
}

void PokedCell::renew_stability() {
  if (!blow_up_) stability_ = stability_solver_.solve(*dynamics_, state_.x_um, kind_, kNextLanczosSteps);
}

double PokedCell::depth_um() const noexcept {
  return tip_along_um_;
}
double PokedCell::push_force_uN() const {
  return model_->tip().force_uN(state_.x_um).dot(mesh_->push);
}
double PokedCell::potential_energy_pJ() const {
  return model_->energy().add(state_.x_um, nullptr, nullptr);
}
double PokedCell::kinetic_energy_pJ() const {
  return 0.5 * dynamics_->node_mass_kg * state_.v_um_per_s.squaredNorm();
}
double PokedCell::volume_change_ratio() const {
  return model_->volume().volume_um3(state_.x_um) / model_->volume().rest_volume_um3() - 1.0;
}
double PokedCell::pressure_Pa() const {
  return parameters_.keeps_volume ? 1e6 * model_->volume().pressure_uN_per_um2(state_.x_um) : 0.0;
}
double PokedCell::largest_speed_um_per_s() const {
  return state_.v_um_per_s.colwise().norm().maxCoeff();
}

NodeForces PokedCell::forces_on(int node) const {
  if (node < 0 || node >= state_.x_um.cols()) {
    throw UsageError("node " + std::to_string(node) + ": give 0 to " + std::to_string(state_.x_um.cols() - 1));
  }
  return node_forces(*model_, mesh_->directions, dynamics_->node_mass_kg, dynamics_->damping_uN_s_per_um, state_,
                     acceleration_um_per_s2_, node);
}

}  // namespace pellucida
