#pragma once
#include <Eigen/Core>

#include "pellucida/haptics/CellGuards.h"
#include "pellucida/haptics/HandMotion.h"
#include "pellucida/haptics/LimitLog.h"

namespace pellucida {

/// The hand in one tick, checked.
struct HandReadout {
  bool good = false;  ///< the two below may be used
  bool anew = false;  ///< they don't follow from those before: the hand is to be engaged anew
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< frame H
  Eigen::Vector3d velocity_m_per_s = Eigen::Vector3d::Zero();
};

/// Readings of the hand to be believed: lost, not finite, jumped and late ones are limits that act. The 1 kHz thread
/// only; nothing allocates or throws.
class HandReader {
 public:
  explicit HandReader(double resolution_m) noexcept : velocity_(resolution_m) {}

  /// `sample`: nothing where the device gave none.
  HandReadout read(const HandSample* sample, double now_s, double dt_s, const CellLimits& limits,
                   ActingLimits& acting) noexcept;

 private:
  HandGuard guard_;
  HandVelocity velocity_;
};

/// Reports of the manipulator to be believed. The 1 kHz thread only; nothing allocates or throws.
class PipetteReader {
 public:
  void see(const PipetteState& state, double max_speed_um_per_s) noexcept;

  /// Whether the pipette is where the newest report says: known and recent.
  bool is_there(double now_s, const CellLimits& limits) const noexcept {
    return known_ && now_s - state_.time_s <= limits.pipette_age_limit_s;
  }
  /// True once after a report that no manipulator can make.
  bool take_jump() noexcept;
  /// Of the newest report, s; 0 without one.
  double age_s(double now_s) const noexcept { return known_ ? now_s - state_.time_s : 0.0; }

  const PipetteState& state() const noexcept { return state_; }

 private:
  PipetteGuard guard_;
  PipetteState state_;
  bool known_ = false, jumped_ = false;
};

}  // namespace pellucida
