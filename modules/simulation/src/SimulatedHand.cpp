#include "pellucida/simulation/SimulatedHand.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

void require_arm(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw UsageError("arm." + std::string(name) + " is " + csv_number(value) + "; allowed: " + csv_number(low) + " to " +
                   csv_number(high));
}

}  // namespace

SimulatedHand::SimulatedHand(const OperatorOptions& options, const OperatorPlan& plan, const ArmOptions& arm,
                             std::uint64_t seed)
    : operator_(options, plan, seed), arm_(arm) {
  require_arm("mass_kg", arm.mass_kg, 0.02, 5);
  require_arm("damping_N_s_per_m", arm.damping_N_s_per_m, 0.5, 100);
  require_arm("stiffness_N_per_m", arm.stiffness_N_per_m, 20, 5000);

  // The arm's own answer to a trembling equilibrium.
  const std::complex<double> s(0.0, 2 * std::numbers::pi * options.tremor_Hz);
  const std::complex<double> drive = arm.damping_N_s_per_m * s + arm.stiffness_N_per_m;
  tremor_gain_ = 1 / std::abs(drive / (arm.mass_kg * s * s + drive));

  specification_.name = "simulated hand";
  specification_.max_force_N = 8.0;
  specification_.max_continuous_force_N = 2.0;
  specification_.max_stiffness_N_per_m = 2000.0;
  specification_.max_damping_N_s_per_m = 5.0;
  specification_.physical_damping_N_s_per_m = arm.damping_N_s_per_m;
  specification_.workspace_radius_m = 0.08;
  specification_.resolution_m = 0.0;
  specification_.source = "a model: the limits of a small desktop device, the damping of the arm";
}

void SimulatedHand::step() noexcept {
  const double dt = SimulatedOperator::kStep_s;
  if (shown_.refresh()) {
    OperatorView view = shown_.value();
    view.time_s -= offset_s_;
    operator_.see(view);
  }
  const OperatorIntent& wanted = operator_.tick(force_N_);
  const Eigen::Vector3d tremor = tremor_gain_ * operator_.tremor_m().eigen();
  const Eigen::Vector3d place = wanted.position_m.eigen() + tremor;
  const Eigen::Vector3d speed = wanted.velocity_m_per_s.eigen() + (tremor - last_tremor_m_.eigen()) / dt;
  last_tremor_m_ = tremor;

  // Semi-implicit in spring and damper: no step is too long for any arm allowed.
  const Eigen::Vector3d x = position_m_.eigen(), v = velocity_m_per_s_.eigen();
  const double k = arm_.stiffness_N_per_m, b = arm_.damping_N_s_per_m;
  const Eigen::Vector3d push = k * (place - x - dt * v) + b * (speed - v) + force_N_.eigen();
  const Eigen::Vector3d now = v + dt / (arm_.mass_kg + dt * b + dt * dt * k) * push;
  velocity_m_per_s_ = now;
  position_m_ = Eigen::Vector3d(x + dt * now);
  inject_ = wanted.inject;
}

bool SimulatedHand::read(double now_s, HandSample& sample) noexcept {
  if (!started_) {
    started_ = true;
    offset_s_ = now_s;
  }
  // Time left out moves the operator's own clock, not the operator.
  const double ahead_s = now_s - offset_s_ - operator_.time_s();
  if (ahead_s > 1.0) offset_s_ += ahead_s - SimulatedOperator::kStep_s;
  while (operator_.time_s() + 0.5 * SimulatedOperator::kStep_s < now_s - offset_s_) step();
  sample.time_s = now_s;
  sample.position_m = position_m_;
  sample.velocity_m_per_s = velocity_m_per_s_;
  sample.velocity_known = true;
  sample.buttons = inject_ ? std::uint32_t{kInject} : 0;
  return true;
}

bool SimulatedHand::write(const PlainVector3& force_N) noexcept {
  const Eigen::Vector3d force = force_N.eigen();
  if (!force.allFinite()) {
    force_N_ = {};
    return false;
  }
  const double size = force.norm(), most = specification_.max_force_N;
  force_N_ = size > most ? PlainVector3(Eigen::Vector3d(force * (most / size))) : force_N;
  return true;
}

}  // namespace pellucida
