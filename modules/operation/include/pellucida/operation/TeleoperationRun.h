#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "pellucida/core/LatestValue.h"
#include "pellucida/haptics/HapticLoop.h"
#include "pellucida/haptics/HapticServo.h"
#include "pellucida/operation/HapticRecorder.h"
#include "pellucida/pipeline/LiveRun.h"
#include "pellucida/teleoperation/ManipulatorStage.h"

namespace pellucida {

/// Status of the hand at one moment.
struct HandStatus {
  HapticRecord tick;         ///< the newest
  std::string device;        ///< its name
  double max_force_N = 0.0;  ///< of the device; 0: no force
  std::string real_time;     ///< real-time privileges granted to the loop, one line
  std::uint64_t tick_count = 0;
  std::uint64_t missed_count = 0;  ///< ticks skipped because they were too late
  double lateness_p99_us = 0.0;
  PipetteState pipette;
  std::optional<std::string> fault;  ///< of the manipulator: one line, while it is lost
};

/// The contact of a run for the hands that work on it, one after the other: the newest frame for the hand at work, and
/// what is known of cell and camera, from each hand to the next. What protects the cell so outlives a change of device
/// or motion scale, even while no frame comes.
class ContactTap {
 public:
  /// Sets the run's contact sink: before the run starts.
  explicit ContactTap(LiveRun& run);

  /// Reader: the 1 kHz loop of the hand at work.
  LatestValue<ContactModel>& newest() noexcept { return *newest_; }

  /// The controlling thread only, while no hand is at work.
  const CellContact& known() const noexcept { return known_; }
  void keep(const CellContact& known) noexcept { known_ = known; }

 private:
  std::shared_ptr<LatestValue<ContactModel>> newest_;  // the run's sink shares it
  CellContact known_;
};

/// The hand on a live run: device, 1 kHz loop, manipulator, each with its thread, fed by the run's measured frames; the
/// hand's activity goes into the run's events and recording. Public calls come from one controlling thread, the
/// emergency stop from any.
class TeleoperationRun {
 public:
  struct Options {
    HapticSettings haptics;
    HapticLoopOptions loop;
    ManipulatorStageOptions manipulator;
  };

  /// All of these must outlive this object; `contacts` is the run's tap, used by this object alone until `stop`. Throws
  /// UsageError if the device can't render the settings.
  TeleoperationRun(LiveRun& run, ContactTap& contacts, HapticDevice& device, MotionMap& map, Manipulator& manipulator,
                   const Options& options);
  ~TeleoperationRun();
  TeleoperationRun(const TeleoperationRun&) = delete;
  TeleoperationRun& operator=(const TeleoperationRun&) = delete;

  /// Opens the manipulator and starts the threads. Throws DeviceError when the manipulator is missing, or the system
  /// refuses an enforced real-time policy.
  void start();
  /// The force fades, the pipette is held, the threads end; the tap keeps what is known of cell and camera.
  void stop();

  /// From the next tick on. Throws as the constructor.
  void set(const HapticSettings& settings);
  const HapticSettings& settings() const noexcept { return options_.haptics; }

  void emergency_stop() noexcept { servo_.emergency_stop(); }
  void release_emergency_stop() noexcept { servo_.release_emergency_stop(); }

  HandStatus status();
  /// The loop's own figures.
  const HapticLoop& loop() const noexcept { return loop_; }

 private:
  LiveRun& run_;
  ContactTap& contacts_;
  Options options_;
  ManipulatorStage manipulator_;
  HapticServo servo_;
  std::unique_ptr<HapticRecorder> recorder_;
  HapticLoop loop_;
};

}  // namespace pellucida
