#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core/Step.h"
#include "pellucida/simulation/CellReference.h"
#include "pellucida/teaching/ReadoutComparison.h"

namespace pellucida {

/// A contour to read, and the node whose forces are explained.
struct ReadoutOrder {
  ReadoutParameters parameters;
  std::optional<int> node;
};

/// Forces over depth by both read-outs, and the truth.
struct ReadoutCurves {
  ReadoutParameters parameters;  ///< their depth and draw aside
  std::vector<double> depth_um, true_uN, equilibrium_uN, prescribed_uN;
};
using ReadoutCurvesPtr = std::shared_ptr<const ReadoutCurves>;

/// Whether both have the same curves.
bool have_same_curves(const ReadoutParameters& a, const ReadoutParameters& b);

/// Contours of the finite elements or of the network itself, read in both ways. One thread at a time.
class ContourReader {
 public:
  expected<ReadoutPair, StepFailure> read(const ReadoutParameters& parameters, std::optional<int> node);

 private:
  std::unique_ptr<ReadoutComparison> comparison_;
  int mesh_frequency_ = 0;
  std::optional<CellReference> reference_;
};

/// One depth. Takes some 20 ms, half a second on a mesh that is new.
class ReadoutStep {
 public:
  using Input = ReadoutOrder;
  using Output = ReadoutPairPtr;
  expected<Output, StepFailure> process(const Input& order);

 private:
  ContourReader reader_;
};

/// All depths, 2 um apart. Takes about a second.
class ReadoutCurveStep {
 public:
  using Input = ReadoutParameters;
  using Output = ReadoutCurvesPtr;
  expected<Output, StepFailure> process(const Input& parameters);

 private:
  ContourReader reader_;
};

}  // namespace pellucida
