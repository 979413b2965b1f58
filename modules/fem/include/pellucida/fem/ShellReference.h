#pragma once
#include <Eigen/Core>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "pellucida/fem/CurveOutcome.h"
#include "pellucida/fem/ShellSpecimen.h"
#include "pellucida/membrane/EquilibriumSolver.h"
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// How the solution is found.
struct ShellOptions {
  /// Factor on all edge lengths. 1 is the reference: about 1,350 nodes, edges of 0.28 of the tip's radius under the
  /// tip. 1.4 is coarse and twice as fast, 0.6 fine; their errors are in docs/method.md, 3.5. 0.2 to 3.
  double edge_length_ratio = 1.0;
  int max_iterations = 40;  ///< of Newton's method for one equilibrium
};

/// The shell at one depth. Frame N.
struct ShellStep {
  double indentation_um = 0.0;                                ///< displacement of the tip
  Eigen::Vector3d tip_force_uN = Eigen::Vector3d::Zero();     ///< of the tip on the shell
  Eigen::Vector3d holder_force_uN = Eigen::Vector3d::Zero();  ///< of the holder on the shell; the tip's, reversed
  double axial_force_uN = 0.0;       ///< the tip's part along the push: the force of a force-indentation curve
  double lateral_force_uN = 0.0;     ///< across the push, in the plane of needle and holder; above 0 towards +x
  double pressure_kPa = 0.0;         ///< of the liquid, above that at rest
  double volume_change_ratio = 0.0;  ///< (V - V0) / V0, of the liquid
  double energy_uN_um = 0.0;         ///< of shell, liquid and bonds; the axial force is its slope
  double largest_stretch = 1.0;      ///< largest principal stretch of the middle surface
  Eigen::Matrix3Xd nodes_um;         ///< (3 x n) of the middle surface
  SolveReport report;                ///< of all solutions since the step before
};

struct ShellCurve {
  CurveOutcome outcome = CurveOutcome::kComplete;
  std::vector<ShellStep> steps;  ///< converged ones only, the first at depth 0
  /// When it did not converge: the depth that failed, and the solver's last report on it.
  double failed_indentation_um = 0.0;
  SolveReport failure;

  double total_force_uN(std::size_t step) const { return steps[step].tip_force_uN.norm(); }
};

/// The section of the shell through the axes of needle and holder, y = 0.
struct ShellSection {
  Eigen::VectorXd rest_angle_rad;  ///< (m) atan2(x, z) at rest, rising, in [-pi, pi)
  Eigen::Matrix2Xd mid_um;         ///< (2 x m) x and z of the middle surface
  Eigen::Matrix2Xd outer_um;       ///< half the rest thickness outwards along the section's normal
  Eigen::Matrix2Xd inner_um;       ///< and inwards
};

/// The quasi-static indentation of a rubber-like spherical shell full of liquid by a bonded rigid tip, by finite
/// elements at finite strain: constant-strain membrane triangles (NeoHookeanTerm), bending at the edges (HingeTerm,
/// D = E h^3 / (12 (1 - nu^2))), one pressure (VolumeTerm), bonded tools (AttachmentTerm). Every equilibrium is a
/// minimum of the energy, found by Newton's method from the last one along its tangent; a step that fails is halved.
///
///     ShellReference reference(ShellSpecimen{}, contact_for_configuration(3));
///     const ShellCurve curve = reference.run(44.0, 2.0);
///     const ShellSection section = reference.section(curve.steps.back());
///
/// One thread at a time; several objects may run in several threads.
class ShellReference {
 public:
  /// Throws UsageError when a number is outside its range, or tip and holder would overlap.
  ShellReference(const ShellSpecimen& specimen, const ShellContact& contact, const ShellOptions& options = {});
  ~ShellReference();
  ShellReference(ShellReference&&) noexcept;
  ShellReference& operator=(ShellReference&&) noexcept;

  const ShellSpecimen& specimen() const noexcept;
  const ShellContact& contact() const noexcept;
  const TriangleMesh& rest() const noexcept;  ///< the middle surface at rest, its plane y = 0 a mirror

  /// The curve at 0, step, 2 step, ... and the largest depth itself, from rest. `progress` is called for every step as
  /// soon as it has converged, with `share`, the part of the depth reached, 0 to 1; `cancel` is checked before every
  /// solution (tens of milliseconds). Throws UsageError unless 0 < step <= max <= 1.4 R.
  ShellCurve run(double max_indentation_um, double step_um,
                 const std::function<void(const ShellStep& step, double share)>& progress = {},
                 const std::stop_token& cancel = {});

  ShellSection section(const ShellStep& step) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
