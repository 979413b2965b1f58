#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core/FieldTable.h"
#include "pellucida/core/Observation.h"
#include "pellucida/core/Step.h"
#include "pellucida/teaching/CellSnapshot.h"

namespace pellucida {

/// What is read, and how well it is seen.
struct ReadoutParameters {
  double depth_um = 10.0;
  double noise_um = 0.0;  ///< of each point of the contour, along its normal, standard deviation
  std::string contour = "finite-elements";
  std::string laying = "equal-distances";
  int mesh_frequency = 9;
  double draw = 1.0;  ///< number of the noise drawn; a whole one
};

/// Keys, units and ranges.
FieldList fields_of(ReadoutParameters& parameters);
/// Throws UsageError for a number out of its range or an unknown contour, with what is allowed.
void require_valid(const ReadoutParameters& parameters);
/// Whether the contour is that of the finite elements. Throws UsageError that lists the names.
bool is_of_finite_elements(const ReadoutParameters& parameters);

/// Where on the contour a node is laid that is to be prescribed.
enum class Laying {
  kNearest,         ///< along its normal, from where the equilibrium has it (`lay_on_contour`)
  kEqualDistances,  ///< as the points of a snake: spread evenly along the contour, as the nodes are at rest
  kTruePlaces,      ///< where that piece of membrane is, which no image shows
};
/// Throws UsageError that lists the names.
Laying laying_of(const std::string& name);

/// Both membranes of a cell in the image plane, without noise, and the force on it. Frame C: x across, z towards the
/// needle, as in CellReference.
struct TrueSection {
  Contour_um outer_um, inner_um;  ///< (2 x n): x, z; closed
  Eigen::VectorXd angle_rad;      ///< (n) of each point at rest, atan2(x, z), rising
  double force_uN = 0.0;
};

/// A force read from a contour, with the shape and the membrane's elastic force on every node that it rests on.
struct Readout {
  double force_uN = 0.0;
  CellSnapshot shape;  ///< with `field_uN`
};

/// The same contour read in two ways.
struct ReadoutPair {
  ReadoutParameters parameters;
  double true_force_uN = 0.0;
  double seen_depth_um = 0.0;  ///< of the contour's tip, noise and all
  Readout equilibrium;         ///< the contour says how deep the needle is; the shape is the model's own
  Readout prescribed;          ///< every node is laid on the contour, and the connectors under the tip are read
};
using ReadoutPairPtr = std::shared_ptr<const ReadoutPair>;

/// Reads contours by the equilibrium, as Pellucida does, and by prescribing every node on the contour revolved, as it
/// does not (docs/method.md, 3.4). The same spring network for both, of the profile `mouse-oocyte`, needle opposite the
/// holder. One thread at a time.
class ReadoutComparison {
 public:
  explicit ReadoutComparison(int mesh_frequency);
  ~ReadoutComparison();

  /// The model's own section at a depth: what an ideal cell would show.
  TrueSection own_section(double depth_um);
  /// Precondition: parameters of this mesh. `node`: whose forces the shapes explain. Fails where there is no
  /// equilibrium. Throws UsageError for parameters that are not valid.
  expected<ReadoutPair, StepFailure> read(const ReadoutParameters& parameters, const TrueSection& section,
                                          std::optional<int> node = {});

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
