#pragma once
#include <memory>
#include <string>
#include <vector>

#include "pellucida/core/Step.h"
#include "pellucida/teaching/TeachingParameters.h"

namespace pellucida {

/// Force over depth of a needle so slow that neither masses nor dampers matter.
struct QuasiStaticCurve {
  TeachingParameters parameters;
  std::vector<double> depth_um;
  std::vector<double> force_uN;
  std::string fault;  ///< why there are no points; empty otherwise
};
using QuasiStaticCurvePtr = std::shared_ptr<const QuasiStaticCurve>;

/// Whether both have the same curve: profile, mesh, modulus and volume are the same.
bool have_same_curve(const TeachingParameters& a, const TeachingParameters& b);

/// Solves the equilibria (`Indenter`) to the deepest the hand can push, 2 um apart. Takes about half a second: for a
/// thread of its own (`Stage`).
class QuasiStaticStep {
 public:
  using Input = TeachingParameters;
  using Output = QuasiStaticCurvePtr;
  expected<Output, StepFailure> process(const Input& parameters);
};

}  // namespace pellucida
