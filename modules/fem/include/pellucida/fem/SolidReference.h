#pragma once
#include <Eigen/Core>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "pellucida/fem/CurveOutcome.h"
#include "pellucida/fem/ShellSpecimen.h"
#include "pellucida/membrane/EquilibriumSolver.h"

namespace pellucida {

struct SolidOptions {
  double edge_length_ratio = 1.0;  ///< factor on the elements' length along the meridian (1: 52 elements); 0.2 to 3
  int across = 3;                  ///< elements through the thickness, 1 to 10
  int max_iterations = 40;         ///< of Newton's method for one equilibrium
  double stiffening = 0.0;         ///< b of the wall's law mu/(2 b) (exp(b (I1 - 3)) - 1), 0 to 2; 0: neo-Hookean
  double aspect_ratio = 1.0;  ///< of the middle surface, a spheroid about the needle's axis: length over width, 0.7
                              ///< to 1.4; the radius is its semi-axes' geometric mean
};

/// The solid at one depth: half-sections (r, z) from the tip's pole to the holder's.
struct SolidStep {
  double indentation_um = 0.0;
  double force_uN = 0.0;         ///< of the tip along the push
  double holder_force_uN = 0.0;  ///< of the holder on the cell, along +z
  double pressure_kPa = 0.0;
  double volume_change_ratio = 0.0;        ///< of the liquid
  double solid_volume_change_ratio = 0.0;  ///< largest of any element
  double energy_uN_um = 0.0;
  Eigen::Matrix2Xd inner_um, mid_um, outer_um;  ///< (2 x m)
  SolveReport report;
};

struct SolidCurve {
  CurveOutcome outcome = CurveOutcome::kComplete;
  std::vector<SolidStep> steps;  ///< converged ones only, the first at depth 0
  double failed_indentation_um = 0.0;
  SolveReport failure;
};

/// The same specimen as ShellReference, as a solid of revolution instead of a thin shell: the error of thin-shell
/// theory at a given thickness is the difference of the two. Nine-node elements with a linear discontinuous pressure,
/// incompressible to one part in a thousand. Configuration 1 only. At nu = 1/2 the material is the same as the shell's;
/// below it is mu/2 (I1 - 3 - 2 ln J) + lambda/2 (J - 1)^2, equal to the shell's at small strain only. It may stiffen
/// with strain and be out of round, which the shell can't.
class SolidReference {
 public:
  /// Throws UsageError when a number is outside its range, or the needle isn't in line with the holder.
  SolidReference(const ShellSpecimen& specimen, const ShellContact& contact, const SolidOptions& options = {});
  ~SolidReference();
  SolidReference(SolidReference&&) noexcept;
  SolidReference& operator=(SolidReference&&) noexcept;

  /// (m) angle of the half-sections' points from the needle's direction at rest, 0 to pi.
  const Eigen::VectorXd& rest_angle_rad() const noexcept;

  /// As ShellReference::run.
  SolidCurve run(double max_indentation_um, double step_um,
                 const std::function<void(const SolidStep& step, double share)>& progress = {},
                 const std::stop_token& cancel = {});

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
