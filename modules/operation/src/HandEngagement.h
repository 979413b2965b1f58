#pragma once
#include <memory>
#include <mutex>

#include "ConsoleDevice.h"
#include "pellucida/operation/TeleoperationRun.h"
#include "pellucida/teleoperation/TeleoperationMap.h"

namespace pellucida {

/// The device that holds the pipette and the loop it is engaged with, one after another; and the emergency stop, which
/// outlives each of them. One thread for all calls but the stop.
class HandEngagement {
 public:
  /// All must outlive the engagement; the run isn't started yet.
  HandEngagement(LiveRun& run, Manipulator& manipulator, const HapticLoopOptions& loop);
  ~HandEngagement();
  HandEngagement(const HandEngagement&) = delete;
  HandEngagement& operator=(const HandEngagement&) = delete;

  /// The device to engage; nullptr: none. The one before is disengaged and closed.
  void set_device(std::unique_ptr<HapticDevice> device);
  ConsoleDevice* device() noexcept { return device_.get(); }
  const ConsoleDevice* device() const noexcept { return device_.get(); }

  /// The device takes the pipette where it is. Throws UsageError for settings the device can't hold, DeviceError where
  /// the manipulator isn't there; nothing is engaged then.
  void engage(const TeleoperationSettings& motion, const HapticSettings& settings);
  /// The force fades, the pipette is held, the loop ends. A stop that the device asked for stays in force.
  void disengage();
  bool engaged() const noexcept { return run_ != nullptr; }

  /// From the next tick on; nothing while no hand is engaged. Throws as `engage`.
  void set(const HapticSettings& settings);

  /// Any thread, at any time; waits for nothing longer than the exchange of a pointer. Latched.
  void emergency_stop() noexcept;
  void release_emergency_stop() noexcept;

  /// Of the loop; waiting or stopped while there is none.
  HandStatus status();

 private:
  LiveRun& live_run_;
  Manipulator& manipulator_;
  HapticLoopOptions loop_;
  ContactTap contacts_;

  // In this order: what the run uses outlives it.
  std::unique_ptr<ConsoleDevice> device_;
  std::unique_ptr<TeleoperationMap> map_;
  std::mutex mutex_;  // of the next two, for the stop from another thread; never held while a loop starts or ends
  bool stopped_ = false;
  std::unique_ptr<TeleoperationRun> run_;
};

}  // namespace pellucida
