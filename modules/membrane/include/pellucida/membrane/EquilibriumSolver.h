#pragma once
#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string_view>

#include "pellucida/membrane/AttachmentTerm.h"
#include "pellucida/membrane/EnergyTerm.h"

namespace pellucida {

/// How a solution ended.
enum class SolveStatus {
  kConverged,
  kIterationBudget,      ///< ran out of iterations
  kTimeBudget,           ///< ran out of time
  kNotPositiveDefinite,  ///< no shift made the Hessian positive definite
  kUnstable,             ///< the shape gives way, and no stable one is nearby
  kNoDescent,            ///< the line search found no lower energy
  kNotFinite,            ///< a number overflowed
};
std::string_view to_string(SolveStatus status) noexcept;

struct SolveOptions {
  int max_iterations = 40;
  double tolerance_um = 2e-6;  ///< converged when every node's residual force is below this times E h
  double max_step_um = 4.0;    ///< no node moves farther in one iteration
  /// No iteration begins later than this after the start. The result then depends on the machine's speed.
  double time_budget_s = std::numeric_limits<double>::infinity();
};

struct SolveReport {
  SolveStatus status = SolveStatus::kIterationBudget;
  int iterations = 0;                     ///< linear systems solved
  int conjugate_gradient_iterations = 0;  ///< spent on them
  int factorizations = 0;                 ///< of those, with a factorisation made anew
  int shifts = 0;                         ///< times the Hessian was not positive definite and was shifted
  double residual_uN = 0.0;               ///< largest residual force on a node
};

/// The response of the equilibrium to a small load b on the nodes.
struct LinearResponse {
  Eigen::Matrix3Xd displacement;  ///< y = H^-1 b (3 x n)
  double compliance = 0.0;        ///< b . H^-1 b; its error is the square of the displacement's
};

/// Finds an equilibrium as a minimum of a sum of energies: Newton's method with a sparse LDL^T factorisation whose
/// symbolic part is kept, rank-one parts (the volume's) by the Sherman-Morrison-Woodbury formula, a pivot-sign test
/// with a diagonal shift until the whole Hessian is positive definite (without it Newton follows unstable branches),
/// and an Armijo line search. The factorisation, which costs nearly all of the time, is kept from one solution to the
/// next for as long as it shrinks the residual fourfold an iteration. One thread at a time.
class EquilibriumSolver {
 public:
  /// Lays down the pattern of the nodes the sum's terms couple and binds them to it. `energy` must outlive the solver;
  /// one solver at a time works on a sum.
  explicit EquilibriumSolver(EnergySum& energy);
  ~EquilibriumSolver();
  EquilibriumSolver(const EquilibriumSolver&) = delete;
  EquilibriumSolver& operator=(const EquilibriumSolver&) = delete;

  /// Moves `x_um` to a minimum of the energy nearby. `x_um` always holds finite numbers afterwards, and no higher
  /// energy than before.
  SolveReport solve(Eigen::Matrix3Xd& x_um, const SolveOptions& options);

  /// The response to `load` (3 x n) with the Hessian at `x_um`, by conjugate gradients preconditioned with the kept
  /// factorisation, to a relative residual of 3e-4; starts from `guess`. Where the Hessian turns out not to be positive
  /// definite, the shifted one is used.
  LinearResponse respond(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& load, const Eigen::Matrix3Xd& guess);
  /// Its displacement alone.
  Eigen::Matrix3Xd apply_inverse_hessian(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& b,
                                         const Eigen::Matrix3Xd& guess);

  /// The change of the force of `tool`, a term of the sum, on the membrane with the tool's displacement: dF/du at the
  /// equilibrium `x_um`, uN/um (3 x 3). Along a direction d: d . (dF/du) d.
  Eigen::Matrix3d tool_stiffness_uN_per_um(const AttachmentTerm& tool, const Eigen::Matrix3Xd& x_um);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
