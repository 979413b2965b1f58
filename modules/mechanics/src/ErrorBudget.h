#pragma once
#include <optional>

#include "CellModelCache.h"
#include "CellPlacement.h"
#include "RelaxingContact.h"
#include "SizesCorrector.h"
#include "pellucida/mechanics/ExpectedPuncture.h"
#include "pellucida/mechanics/ForceEstimate.h"
#include "pellucida/membrane/PalpationUpdate.h"

namespace pellucida {

/// What a contour may differ from the model by at a depth, um: its noise, and what is usual beside it.
double usual_mismatch_um(const ShapeAudit& shape, double depth_um);

/// Everything that one frame's force is known by.
struct BudgetInput {
  const CellProfile& profile;
  const CellModelCache& cell;
  const CellPlacement& placement;
  const CellScale& scale;
  double depth_um = 0.0;
  double model_force_uN = 0.0;  ///< as the profile's modulus gives it, neither scaled nor relaxed
  RelaxingContact::Force force;
  const SizesCorrection& sizes;  ///< what contours say of the force's errors
};

/// Writes `errors`, `warnings` and `asymmetry_force_uN` of an estimate in contact that has its depth's sigma, its shape
/// and what was assumed.
void fill_errors(const BudgetInput& input, ForceEstimate& estimate);

}  // namespace pellucida
