#pragma once
#include <atomic>
#include <cstdint>

#include "pellucida/core/LatestValue.h"
#include "pellucida/core/SpscRing.h"
#include "pellucida/haptics/HapticStep.h"

namespace pellucida {

/// Input and output slots of a tick: they belong to the stages on the other side and outlive the servo. The servo is
/// the only reader of the first two and the only writer of the third.
struct HapticPorts {
  LatestValue<ContactModel>& contact;
  LatestValue<PipetteState>& pipette;
  LatestValue<PipetteCommand>& command;
};

/// One turn of the loop with everything it touches: device, exchanges, the step. Order of a turn: read, newest contact
/// model, compute, guards (in the step), write, ring record, counters. The caller supplies the time: the loop's thread,
/// or a test without one.
class HapticServo {
 public:
  /// Records that can wait to be drained: 8 s.
  static constexpr std::size_t kRecordCapacity = 8192;
  static constexpr std::size_t kEventCapacity = 1024;

  /// `device`, `map` and the slots of `ports` must outlive the servo. `known`: what the servo before it knew of cell
  /// and camera. Throws UsageError when the settings have a fault.
  HapticServo(HapticDevice& device, MotionMap& map, const HapticPorts& ports, const HapticSettings& settings,
              const CellContact& known = CellContact{});
  HapticServo(const HapticServo&) = delete;
  HapticServo& operator=(const HapticServo&) = delete;

  /// The turning thread only. `now_s`: the run's clock. `release_hand`: the loop is about to end, the force goes to
  /// zero.
  /// No call allocates, locks or throws.
  void turn(double now_s, bool release_hand = false) noexcept;

  /// What is known of cell and camera, for the next servo. The turning thread, or any once nobody turns any more.
  const CellContact& contact() const noexcept { return step_.contact(); }

  /// Writes zero to the device. The turning thread only.
  void release() noexcept;

  /// One other thread: new settings, from the next turn on. Throws UsageError stating what is wrong, and which scaling
  /// would be accepted.
  void set(const HapticSettings& settings);

  /// Any thread, at any time: stops everything; latched. Wins over a release of the same moment.
  void emergency_stop() noexcept { stop_.store(true, std::memory_order_release); }
  /// Any thread: only at the user's explicit request.
  void release_emergency_stop() noexcept { release_.store(true, std::memory_order_release); }

  /// One other thread each drains these.
  SpscRing<HapticRecord, kRecordCapacity>& records() noexcept { return records_; }
  SpscRing<LimitEvent, kEventCapacity>& events() noexcept { return events_; }
  /// One other thread: the newest tick, for a display.
  LatestValue<HapticRecord>& newest() noexcept { return newest_; }

  /// Any thread.
  std::uint64_t tick_count() const noexcept { return tick_count_.load(std::memory_order_relaxed); }
  std::uint64_t device_fault_count() const noexcept { return device_fault_count_.load(std::memory_order_relaxed); }
  const DeviceSpecification& specification() const noexcept { return device_.specification(); }

 private:
  HapticDevice& device_;
  HapticPorts ports_;
  HapticStep step_;
  LatestValue<HapticSettings> settings_;
  SpscRing<HapticRecord, kRecordCapacity> records_;
  SpscRing<LimitEvent, kEventCapacity> events_;
  LatestValue<HapticRecord> newest_;
  std::atomic<bool> stop_{false}, release_{false};
  std::atomic<std::uint64_t> tick_count_{0}, device_fault_count_{0};
  std::atomic<double> scale_um_per_m_;  ///< of the newest turn: the map itself belongs to the turning thread
  double last_s_ = 0.0;
  bool started_ = false;
  bool write_failed_ = false;
};

}  // namespace pellucida
