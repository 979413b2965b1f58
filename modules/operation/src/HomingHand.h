#pragma once
#include <algorithm>

#include "pellucida/core/LatestValue.h"
#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {

/// Leads the needle straight to a place, for a person who has lost it. It is a device like any other, so that guards,
/// limits and the emergency stop act as ever. `see` from the window's thread, `read` and `write` from the loop's.
class HomingHand final : public HapticDevice {
 public:
  /// `scale_um_per_m`: of the motion map it is engaged with.
  HomingHand(const PlainVector3& home_um, double scale_um_per_m) : home_um_(home_um), scale_um_per_m_(scale_um_per_m) {
    specification_.name = "Needle brought back";
    specification_.source = "software";
  }

  /// Where the tip is: the way left follows from it.
  void see(const PlainVector3& tip_um) noexcept { tip_um_.publish(tip_um); }

  const DeviceSpecification& specification() const noexcept override { return specification_; }

  bool read(double now_s, HandSample& sample) noexcept override {
    constexpr double kLongestStep_s = 0.02, kNearer_per_s = 3.0, kFastest_um_per_s = 800.0, kThere_um = 0.5;
    const double elapsed_s = last_s_ > 0.0 ? std::clamp(now_s - last_s_, 0.0, kLongestStep_s) : 0.0;
    last_s_ = now_s;
    if (tip_um_.refresh()) is_seen_ = true;
    if (is_seen_) {
      const Eigen::Vector3d left_um = home_um_.eigen() - tip_um_.value().eigen();
      const double length_um = left_um.norm();
      if (length_um > kThere_um) {
        const double step_um = std::min(kNearer_per_s * length_um, kFastest_um_per_s) * elapsed_s;
        const PlainVector3 step{Eigen::Vector3d(step_um / length_um / scale_um_per_m_ * left_um)};
        position_m_ = Eigen::Vector3d(position_m_.eigen() + hand_from_world(step).eigen());
      }
    }
    sample = {};
    sample.time_s = now_s;
    sample.position_m = position_m_;
    return true;
  }

  bool write(const PlainVector3&) noexcept override { return true; }

 private:
  PlainVector3 home_um_;
  double scale_um_per_m_;
  DeviceSpecification specification_;
  LatestValue<PlainVector3> tip_um_;
  bool is_seen_ = false;
  double last_s_ = 0.0;
  PlainVector3 position_m_;
};

}  // namespace pellucida
