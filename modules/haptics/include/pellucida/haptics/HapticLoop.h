#pragma once
#include <atomic>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <thread>

#include "pellucida/core/Clock.h"
#include "pellucida/haptics/HapticServo.h"
#include "pellucida/haptics/LatencyHistogram.h"
#include "pellucida/haptics/RealTime.h"

namespace pellucida {

struct HapticLoopOptions {
  double period_s = 1e-3;
  RealTimePolicy policy = RealTimePolicy::kIgnore;
  int priority = 80;        ///< of SCHED_FIFO, 1..99; 0: not requested
  bool lock_memory = true;  ///< of the whole process
};

/// The 1 kHz thread: runs a `HapticServo` at absolute deadlines. A deadline missed by more than a period is skipped and
/// counted, never made up in a burst. Before the loop ends, the force goes to zero within its release time.
class HapticLoop {
 public:
  /// Servo and clock (the run's) must outlive the loop. Throws UsageError for a period or priority out of range.
  HapticLoop(HapticServo& servo, const Clock& clock, const HapticLoopOptions& options = {});
  ~HapticLoop();
  HapticLoop(const HapticLoop&) = delete;
  HapticLoop& operator=(const HapticLoop&) = delete;

  /// Starts the thread. With `kEnforce`, throws DeviceError if priority or locked memory are refused. Not to be called
  /// while running.
  void start();

  /// Ends the thread: the force fades, zero is written. No effect when not running.
  void stop();

  bool running() const noexcept { return thread_.joinable(); }

  /// What the system granted at `start`. The starting thread only.
  const RealTimeOutcome& real_time() const noexcept { return outcome_; }

  /// Any thread. Lateness: from the deadline to the start of the turn. Compute: the turn itself, device included.
  const LatencyHistogram& lateness() const noexcept { return lateness_; }
  const LatencyHistogram& compute() const noexcept { return compute_; }
  std::uint64_t missed_count() const noexcept { return missed_count_.load(std::memory_order_relaxed); }

 private:
  void run(std::stop_token stop);
  void turn_at(std::int64_t deadline_ns, bool release_hand) noexcept;
  std::int64_t next_deadline_ns(std::int64_t deadline_ns) noexcept;

  HapticServo& servo_;
  const Clock& clock_;
  HapticLoopOptions options_;
  std::int64_t period_ns_;
  RealTimeOutcome outcome_;
  std::optional<QuickWakeRequest> quick_wake_;  ///< while the thread runs
  LatencyHistogram lateness_, compute_;
  std::atomic<std::uint64_t> missed_count_{0};
  std::atomic<bool> go_{false};  ///< the thread waits for its priority before its first turn
  std::jthread thread_;
};

}  // namespace pellucida
