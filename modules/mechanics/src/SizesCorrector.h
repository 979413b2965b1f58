#pragma once
#include <optional>

#include "CellModelCache.h"
#include "CellPlacement.h"
#include "ContourSizes.h"
#include "pellucida/core/Observation.h"
#include "pellucida/mechanics/ForceEstimate.h"

namespace pellucida {

/// What contours in contact say of the force, beside the sizes that the model was built for.
struct SizesCorrection {
  double ratio = 1.0;           ///< on the forces of the tools
  double slope_per_um = 0.0;    ///< its derivative by depth
  double pressure_ratio = 1.0;  ///< on the liquid's pressure: a thick wall yields under the needle by itself
  double push_ratio = 1.0;  ///< on the liquid's push on the middle surface, whose inner face moves with the thickness
  /// Of the force, from thickness, tip and holder at this depth, and of its law; none: by usual powers.
  std::optional<double> log_sigma;
  double elongation_log_sigma = 0.0;  ///< of the force, from how wide an oval cell is across the picture
  /// Of the force, from how the wall stiffens; none: as the kind does.
  std::optional<double> stiffening_log_sigma;
};

/// Follows what the contours of a cell say of its sizes and of its wall, without jumps, and what the force is
/// multiplied by for it. One thread at a time.
class SizesCorrector {
 public:
  /// An untouched cell.
  void add_rest(const Observation& observation, const CellPlacement& placement) {
    contours_.add_rest(observation, placement);
  }
  /// The model was built anew.
  void clear() noexcept;
  /// Another cell.
  void forget();

  /// A frame in contact, at a depth above 0 and known to `depth_sigma_um`. `is_doubted`: its contour is not to be
  /// learnt from. A scale from a push has the cell's sizes and wall in it, at that push's depth: what is left is how
  /// much more the wall changes elsewhere.
  SizesCorrection follow(const Observation& observation, const CellPlacement& placement, const CellModelCache& cell,
                         double depth_um, double depth_sigma_um, bool is_doubted, const CellScale& scale);
  /// Of the last frame that was followed; nothing where the contours say nothing.
  std::optional<SizesByContour> sizes() const;

 private:
  ContourSizes contours_;
  SolidParameters change_ = SolidParameters::Zero();  // in use, beside the model's own
  double radius_um_ = 0.0, ratio_ = 1.0;
  bool has_open_size_ = false;
};

}  // namespace pellucida
