#pragma once
#include <Eigen/Core>
#include <memory>

#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/MembraneModel.h"

namespace pellucida {

/// The nine constants that the model's energy is linear in, each in terms of E h or D: for the tip's region, the body,
/// the holder's region in turn K2 / (E h), K1 / (E h), g.
using ModelConstants = Eigen::Matrix<double, 9, 1>;

ModelConstants constants_of(const CellProfile& profile);
void set_constants(CellProfile& profile, const ModelConstants& constants);

/// A force-indentation curve and how it follows the constants.
struct CurveWithSlopes {
  Eigen::VectorXd force_uN;                            ///< (n) along the push, as many as were reached
  Eigen::Matrix<double, Eigen::Dynamic, 9> slopes_uN;  ///< (n x 9) dF / d(constant)
  bool complete = false;                               ///< an equilibrium was found at every depth
};

/// The model's curve with its exact derivatives by the nine constants p, without finite differences. The force is the
/// slope of the least energy, F = dU*/dd, and dU*/dp = (dU/dp)(x*) at a minimum, so
///
///     dF/dp = d/dd (dU/dp)(x*) = (dg/dp) . dx*/dd,     H dx*/dd = w push,     g = grad U,
///
/// which is the adjoint solution with the factorisation at hand: dx*/dd is the tangent that the solver starts the next
/// depth with, and dg/dp is the gradient of one region's connectors or hinges with a constant of 1. One thread at a
/// time; several objects may work in several threads.
class CurveSensitivity {
 public:
  /// The geometry, bonds, mesh and modulus of `profile`; its constants don't matter.
  CurveSensitivity(CellProfile profile, const MembraneSetup& setup);
  ~CurveSensitivity();
  CurveSensitivity(CurveSensitivity&&) noexcept;
  CurveSensitivity& operator=(CurveSensitivity&&) noexcept;

  /// The curve at `depths_um` (n), rising and at least 0, from rest. Throws UsageError when they aren't.
  CurveWithSlopes solve(const ModelConstants& constants, const Eigen::VectorXd& depths_um) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
