#pragma once
#include <Eigen/Core>
#include <memory>
#include <string_view>

#include "pellucida/membrane/EnergyTerm.h"
#include "pellucida/membrane/EquilibriumSolver.h"
#include "pellucida/membrane/SpringTerm.h"

namespace pellucida {

/// Where the nodes are and how they move.
struct MotionState {
  Eigen::Matrix3Xd x_um;        ///< (3 x n)
  Eigen::Matrix3Xd v_um_per_s;  ///< (3 x n)
};

/// The system: M x'' + B(x) x' + grad U(x) = 0, eq. (2) of the paper. The same mass on every node, as in the paper, and
/// the dampers of eq. (1) along the connectors. Units: kg um/s^2 = uN.
struct Dynamics {
  EnergySum& energy;                 ///< all forces that have a potential: springs, hinges, pressure, tools
  const SpringTerm& springs;         ///< where the dampers lie
  double node_mass_kg = 0.0;         ///< > 0
  double damping_uN_s_per_um = 0.0;  ///< b, >= 0

  /// Kinetic and potential energy, uN um.
  double total_energy_uN_um(const MotionState& state) const;
};

/// One time step of the dynamics. An integrator refers to the terms that the Dynamics' energy has as it is made; they
/// must outlive it. The implicit ones bind them to a solver of their own; no other solver may use them meanwhile.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual std::string_view name() const noexcept = 0;
  /// Advances `state` by `dt_s` > 0. False when that was not possible (see each class); `state` is then unchanged.
  virtual bool step(MotionState& state, double dt_s) = 0;
};

/// Eq. (4), the semi-implicit (symplectic) Euler method: v += F(x, v) dt / m, x += v dt. Order 1, explicit, keeps
/// energy over long times; stable below dt = 2 / omega_max (less with damping). False when a number overflows.
std::unique_ptr<Integrator> make_symplectic_euler(const Dynamics& dynamics);

/// Implicit Euler: v' = v + F(x', v') dt / m, x' = x + v' dt, as the minimum of U + m/(2 dt^2) |x' - x - v dt|^2 + the
/// dampers' share, the connectors' directions for damping being those of x. Order 1, stable at any step, dissipates
/// energy. False when the solver doesn't converge.
std::unique_ptr<Integrator> make_implicit_euler(const Dynamics& dynamics);

/// The linear acceleration method (Newmark, beta = 1/6, gamma = 1/2), implicit: the acceleration varies linearly over a
/// step. Order 2; stable below dt = 3.46 / omega_max. False when the solver doesn't converge. Keeps the acceleration
/// from step to step: use one for one motion.
std::unique_ptr<Integrator> make_linear_acceleration(const Dynamics& dynamics);

}  // namespace pellucida
