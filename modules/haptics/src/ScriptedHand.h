#pragma once
#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/haptics/MotionMap.h"

namespace pellucida {

/// A hand without a person: pushes along +x, draws back, sways across. It takes any force without giving way.
class ScriptedHand final : public HapticDevice {
 public:
  explicit ScriptedHand(DeviceSpecification specification);
  const DeviceSpecification& specification() const noexcept override { return specification_; }
  bool read(double now_s, HandSample& sample) noexcept override;
  bool write(const PlainVector3& force_N) noexcept override;

 private:
  DeviceSpecification specification_;
};

/// Hand to tip by a fixed scale.
class PlainMap final : public MotionMap {
 public:
  explicit PlainMap(double scale_um_per_m) noexcept : scale_(scale_um_per_m) {}
  void engage(const HandSample& hand, const PlainVector3& tip_um) noexcept override;
  TipTarget update(const HandSample& hand, double dt_s) noexcept override;
  double scale_um_per_m() const noexcept override { return scale_; }

 private:
  double scale_;
  PlainVector3 offset_um_;  ///< tip less scaled hand
};

}  // namespace pellucida
