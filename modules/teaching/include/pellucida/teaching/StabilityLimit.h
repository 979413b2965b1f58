#pragma once
#include <Eigen/Core>
#include <limits>

#include "pellucida/dynamics/Integrator.h"
#include "pellucida/teaching/TeachingParameters.h"

namespace pellucida {

/// What the theory of linear vibration says about a time step, at one shape.
struct StabilityLimit {
  double stiffest_mode_uN_per_um = 0.0;  ///< largest eigenvalue of the Hessian
  double omega_max_per_s = 0.0;          ///< sqrt(that / m)
  double stable_step_s = std::numeric_limits<double>::infinity();
};

/// Finds the limit by Lanczos' method, with the Hessian taken from differences of the gradient. Steps above it grow
/// without bound, at which a mode turns round at each step (x -> -x):
///
///   symplectic Euler     dt^2 K + 2 dt B = 4 m     (2 / omega_max without dampers)
///   linear acceleration  dt^2 K = 12 m             (dampers don't matter)
///   implicit Euler       none
///
/// K the Hessian, B the dampers' matrix. Keeps the mode found, from which a shape nearby is solved sooner.
class StabilitySolver {
 public:
  /// `x_um` (3 x n). `lanczos_steps` 1..60: products with K; about 30 give three digits from nothing, ten from a mode
  /// nearby.
  StabilityLimit solve(const Dynamics& dynamics, const Eigen::Matrix3Xd& x_um, IntegratorKind kind, int lanczos_steps);

 private:
  Eigen::VectorXd mode_;
};

}  // namespace pellucida
