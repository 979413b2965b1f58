#pragma once
#include <Eigen/Core>

#include "pellucida/haptics/ForceGuards.h"
#include "pellucida/haptics/HapticSettings.h"
#include "pellucida/haptics/LimitLog.h"
#include "pellucida/haptics/PassivityObserver.h"
#include "pellucida/haptics/Readings.h"

namespace pellucida {

/// The last way of a force before it reaches the hand: faded by how much the hand works, made passive, then finite,
/// low-pass, slope, saturation, finite. Frame H, N. The 1 kHz thread only. Nothing allocates, locks or throws.
class HandForce {
 public:
  HandForce(const DeviceSpecification& device, double period_s) noexcept;

  /// The hand has moved against the force written last: the energy it put in or took out. `follows`: this reading
  /// continues the motion of those before.
  void observe(const HandReadout& hand, bool follows, double dt_s) noexcept;

  /// The part of the force that is given moves to 1 or 0 within `time_s`.
  void fade(bool works, double time_s, double dt_s) noexcept { work_.step(works ? 1.0 : 0.0, time_s, dt_s); }
  double part() const noexcept { return work_.value(); }

  /// What is written of the force `wanted_W_N` (frame W); zero for a device without force.
  Eigen::Vector3d written_N(const Eigen::Vector3d& wanted_W_N, const HandReadout& hand, const HapticSettings& settings,
                            double dt_s, ActingLimits& acting) noexcept;

  double margin_J() const noexcept { return passivity_.margin_J(); }

 private:
  double max_force_N_;
  PassivityObserver passivity_;
  Ramp work_;
  Eigen::Vector3d filtered_N_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d written_N_ = Eigen::Vector3d::Zero();
};

}  // namespace pellucida
