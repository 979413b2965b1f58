#pragma once
#include "pellucida/core/PlainVector.h"
#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {

/// Where the hand wants the pipette's tip. Frame W.
struct TipTarget {
  PlainVector3 tip_um;
  PlainVector3 velocity_um_per_s;
  bool clutched = false;  ///< disengaged: the target does not move, and no force is felt

  /// How far ahead the target would be without the map's smoothing filters, um; zero for a map without filters. The
  /// pipette receives the smoothed motion, but the hand must feel its own position: a force that lags makes any contact
  /// oscillate.
  PlainVector3 ahead_um;
};

/// How hand motion becomes tip motion (position or rate control, scale, clutch, filters). Called by the 1 kHz thread:
/// neither allocates, locks, logs nor throws.
class MotionMap {
 public:
  virtual ~MotionMap() = default;

  /// Anchors the hand's position to the tip's: the next target is exactly `tip_um`.
  virtual void engage(const HandSample& hand, const PlainVector3& tip_um) noexcept = 0;

  /// The target of this tick; `dt_s` since the last one.
  virtual TipTarget update(const HandSample& hand, double dt_s) noexcept = 0;

  /// Tip motion for a hand motion, um/m (above 0): it converts uN/um at the cell into N/m at the hand.
  virtual double scale_um_per_m() const noexcept = 0;

  /// A force of the map's own on the hand, frame H, N: the return to the centre of a rate control.
  virtual PlainVector3 hand_force_N(const HandSample&) const noexcept { return {}; }
};

}  // namespace pellucida
