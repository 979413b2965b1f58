#pragma once
#include <Eigen/Core>

#include "FrameSampler.h"
#include "NeedleModel.h"
#include "TipNetwork.h"

namespace pellucida {

/// Reads the tip of one needle frame after frame. The large networks read it every few frames; in those between the
/// small one does, set right by how far it was off when both read the same frame: what it takes for this needle's end
/// is the same then. A frame that it sees less well, or that has the tip elsewhere than it is due, is for the large
/// ones.
class TipFollower {
 public:
  /// The tip due at `axis.tip` of a needle `half_width_px` wide some way behind it; `may_be_quick`: else the large
  /// networks read it.
  TipReading read(TipNetwork& network, const FrameSampler& image, const NeedleAxis& axis, double half_width_px,
                  bool may_be_quick);

 private:
  bool go_on(TipNetwork& network, const FrameSampler& image, const NeedleAxis& axis, double half_width_px,
             TipReading& reading) const;
  bool compare(TipNetwork& network, const FrameSampler& image, const NeedleAxis& axis, double half_width_px);
  static bool is_due(const TipReading& reading, const NeedleAxis& axis, double half_width_px);

  TipReading read_;                     // by the large networks, last
  double share_ = 0.0;                  // of the small one's answer in that frame
  Eigen::Vector2d apart_px_{0.0, 0.0};  // along and across, how far that was from theirs
  int comparisons_ = 0, frames_ = 0;    // with both in a row; since the last one
};

}  // namespace pellucida
