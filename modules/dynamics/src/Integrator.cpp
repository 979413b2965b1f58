#include "pellucida/dynamics/Integrator.h"

#include "MotionTerms.h"

namespace pellucida {

double Dynamics::total_energy_uN_um(const MotionState& state) const {
  return energy.add(state.x_um, nullptr, nullptr) + 0.5 * node_mass_kg * state.v_um_per_s.squaredNorm();
}

namespace {

constexpr double kTolerance_um = 1e-8;
constexpr double kRounding_um = 1e-11;

class SymplecticEuler final : public Integrator {
 public:
  explicit SymplecticEuler(const Dynamics& dynamics) : dynamics_(dynamics) {}
  std::string_view name() const noexcept override { return "symplectic Euler"; }

  bool step(MotionState& state, double dt_s) override {
    force_uN_.setZero(3, state.x_um.cols());
    dynamics_.energy.add(state.x_um, &force_uN_, nullptr);
    force_uN_ = -force_uN_;
    if (dynamics_.damping_uN_s_per_um > 0.0) {
      dynamics_.springs.add_damping(state.x_um, state.v_um_per_s, dynamics_.damping_uN_s_per_um, force_uN_);
    }
    if (!force_uN_.allFinite()) return false;
    state.v_um_per_s += (dt_s / dynamics_.node_mass_kg) * force_uN_;
    state.x_um += dt_s * state.v_um_per_s;
    return true;
  }

 private:
  Dynamics dynamics_;
  Eigen::Matrix3Xd force_uN_;
};

/// The implicit methods are one: with a = (x - x_a) / (beta dt^2) and v = v_r + rate (x - x_r) at the step's end, the
/// new x is a minimum of U + inertia + dampers.
class ImplicitIntegrator : public Integrator {
 public:
  explicit ImplicitIntegrator(const Dynamics& dynamics)
      : dynamics_(dynamics),
        dampers_(dynamics.springs),
        sum_(dynamics.energy.node_count(), dynamics.energy.force_scale_uN_per_um()) {
    for (EnergyTerm* term : dynamics.energy.terms()) sum_.add_term(*term);
    sum_.add_term(inertia_);
    sum_.add_term(dampers_);
    solver_ = std::make_unique<EquilibriumSolver>(sum_);
  }

 protected:
  /// Solves for `x_um`, which holds a first guess.
  bool solve(double beta_dt2_s2, const Eigen::Matrix3Xd& inertia_target_um, double rate_per_s,
             const Eigen::Matrix3Xd& begin_um, const Eigen::Matrix3Xd& reference_um,
             const Eigen::Matrix3Xd& reference_v_um_per_s, Eigen::Matrix3Xd& x_um) {
    inertia_.set(dynamics_.node_mass_kg / beta_dt2_s2, inertia_target_um);
    dampers_.set(dynamics_.damping_uN_s_per_um, rate_per_s, begin_um, reference_um, reference_v_um_per_s);
    // As exact as rounding lets it: inertia times the last digits of a place.
    const double inertia_uN_per_um = dynamics_.node_mass_kg / beta_dt2_s2;
    SolveOptions options;
    options.tolerance_um = kTolerance_um + kRounding_um * inertia_uN_per_um / sum_.force_scale_uN_per_um();
    return solver_->solve(x_um, options).status == SolveStatus::kConverged;
  }

  Dynamics dynamics_;

 private:
  InertiaTerm inertia_;
  DamperTerm dampers_;
  EnergySum sum_;  // the dynamics' terms, and those of a step
  std::unique_ptr<EquilibriumSolver> solver_;
};

class ImplicitEuler final : public ImplicitIntegrator {
 public:
  using ImplicitIntegrator::ImplicitIntegrator;
  std::string_view name() const noexcept override { return "implicit Euler"; }

  bool step(MotionState& state, double dt_s) override {
    target_um_ = state.x_um + dt_s * state.v_um_per_s;
    x_um_ = target_um_;
    still_.setZero(3, state.x_um.cols());
    if (!solve(dt_s * dt_s, target_um_, 1.0 / dt_s, state.x_um, state.x_um, still_, x_um_)) return false;
    state.v_um_per_s = (x_um_ - state.x_um) / dt_s;
    state.x_um = x_um_;
    return true;
  }

 private:
  Eigen::Matrix3Xd target_um_, x_um_, still_;
};

class LinearAcceleration final : public ImplicitIntegrator {
 public:
  using ImplicitIntegrator::ImplicitIntegrator;
  std::string_view name() const noexcept override { return "linear acceleration"; }

  bool step(MotionState& state, double dt_s) override {
    constexpr double kBeta = 1.0 / 6.0, kGamma = 0.5;
    if (acceleration_.cols() != state.x_um.cols()) begin(state);
    target_um_ = state.x_um + dt_s * state.v_um_per_s + ((0.5 - kBeta) * dt_s * dt_s) * acceleration_;
    reference_v_ = state.v_um_per_s + ((1.0 - kGamma) * dt_s) * acceleration_;
    x_um_ = target_um_ + (kBeta * dt_s * dt_s) * acceleration_;
    const double beta_dt2_s2 = kBeta * dt_s * dt_s;
    if (!solve(beta_dt2_s2, target_um_, kGamma / (kBeta * dt_s), state.x_um, target_um_, reference_v_, x_um_)) {
      return false;
    }
    acceleration_ = (x_um_ - target_um_) / beta_dt2_s2;
    state.v_um_per_s = reference_v_ + (kGamma * dt_s) * acceleration_;
    state.x_um = x_um_;
    return true;
  }

 private:
  /// The acceleration where the motion begins.
  void begin(const MotionState& state) {
    Eigen::Matrix3Xd force_uN = Eigen::Matrix3Xd::Zero(3, state.x_um.cols());
    dynamics_.energy.add(state.x_um, &force_uN, nullptr);
    force_uN = -force_uN;
    dynamics_.springs.add_damping(state.x_um, state.v_um_per_s, dynamics_.damping_uN_s_per_um, force_uN);
    acceleration_ = force_uN / dynamics_.node_mass_kg;
  }

  Eigen::Matrix3Xd target_um_, x_um_, reference_v_, acceleration_;
};

}  // namespace

std::unique_ptr<Integrator> make_symplectic_euler(const Dynamics& dynamics) {
  return std::make_unique<SymplecticEuler>(dynamics);
}
std::unique_ptr<Integrator> make_implicit_euler(const Dynamics& dynamics) {
  return std::make_unique<ImplicitEuler>(dynamics);
}
std::unique_ptr<Integrator> make_linear_acceleration(const Dynamics& dynamics) {
  return std::make_unique<LinearAcceleration>(dynamics);
}

}  // namespace pellucida
