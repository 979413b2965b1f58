#pragma once
#include <Eigen/Core>
#include <memory>
#include <string_view>

#include "pellucida/mechanics/MembraneModel.h"

namespace pellucida {

/// How a solution ended.
enum class SolveStatus {
  kConverged,
  kIterationBudget,  ///< ran out of iterations
  kNoDescent,        ///< the line search found no lower energy
  kNotFinite,        ///< a number overflowed
};
std::string_view to_string(SolveStatus status) noexcept;

struct SolveOptions {
  int max_iterations = 40;
  double tolerance_um = 1e-5;  ///< converged when every node's residual force is below this times E h
  double max_step_um = 4.0;    ///< no node moves farther in one iteration
};

struct SolveReport {
  SolveStatus status = SolveStatus::kIterationBudget;
  int iterations = 0;        ///< linear systems solved
  int factorizations = 0;    ///< of those, with a factorisation made anew
  int shifts = 0;            ///< times the Hessian wasn't positive definite and was shifted
  double residual_uN = 0.0;  ///< largest residual force on a node
};

/// Finds the membrane's equilibrium as a minimum of its energy: Newton's method with a sparse LDL^T factorisation whose
/// symbolic part is kept, the volume's rank-one part by the Sherman-Morrison formula, a pivot-sign test with a diagonal
/// shift until the whole Hessian is positive definite (without it Newton follows unstable branches), and an Armijo line
/// search. The factorisation, which costs nearly all of the time, is kept from one solution to the next for as long as
/// it shrinks the residual fourfold an iteration. One thread at a time. Works on a model of the node coupling it was
/// made for.
class EquilibriumSolver {
 public:
  explicit EquilibriumSolver(MembraneModel& model);
  ~EquilibriumSolver();
  EquilibriumSolver(const EquilibriumSolver&) = delete;
  EquilibriumSolver& operator=(const EquilibriumSolver&) = delete;

  /// Moves `x_um` to a minimum of `model`'s energy nearby. `x_um` always holds finite numbers afterwards.
  SolveReport solve(const MembraneModel& model, Eigen::Matrix3Xd& x_um, const SolveOptions& options);

  /// H^-1 b with the Hessian at `x_um` (3 x n), by conjugate gradients preconditioned with the kept factorisation, to a
  /// relative residual of 1e-4; starts from `guess`. Where the Hessian turns out not to be positive definite, the
  /// shifted one is used.
  Eigen::Matrix3Xd apply_inverse_hessian(const MembraneModel& model, const Eigen::Matrix3Xd& x_um,
                                         const Eigen::Matrix3Xd& b, const Eigen::Matrix3Xd& guess);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
