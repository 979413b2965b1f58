#include "pellucida/haptics/HapticLoop.h"

#include <time.h>

#include <cerrno>
#include <cmath>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr int kReleaseTurns = 30;

std::int64_t monotonic_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * kSecond_ns + now.tv_nsec;
}

void sleep_until(std::int64_t deadline_ns) noexcept {
  timespec deadline{};
  deadline.tv_sec = static_cast<time_t>(deadline_ns / kSecond_ns);
  deadline.tv_nsec = static_cast<long>(deadline_ns % kSecond_ns);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
}

}  // namespace

HapticLoop::HapticLoop(HapticServo& servo, const Clock& clock, const HapticLoopOptions& options)
    : servo_(servo),
      clock_(clock),
      options_(options),
      period_ns_(static_cast<std::int64_t>(std::llround(options.period_s * 1e9))) {
  if (!(options.period_s >= 1e-5 && options.period_s <= 0.1)) {
    throw UsageError("haptic loop: a period of " + std::to_string(options.period_s) + " s; take 0.00001 .. 0.1 s");
  }
  if (options.priority < 0 || options.priority > 99) {
    throw UsageError("haptic loop: a priority of " + std::to_string(options.priority) + "; take 0 .. 99");
  }
}

HapticLoop::~HapticLoop() {
  stop();
}

void HapticLoop::start() {
  if (running()) throw UsageError("haptic loop: it runs already; stop it first");
  outcome_ = RealTimeOutcome{};
  lateness_.clear();
  compute_.clear();
  missed_count_.store(0, std::memory_order_relaxed);
  go_.store(false, std::memory_order_release);
  thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
  if (options_.priority > 0) raise_priority(thread_.native_handle(), options_.priority, outcome_);
  if (options_.lock_memory) lock_memory(outcome_);
  if (options_.policy == RealTimePolicy::kEnforce && !outcome_.refused.empty()) {
    thread_.request_stop();
    go_.store(true, std::memory_order_release);
    go_.notify_all();
    thread_.join();
    throw DeviceError("haptic loop: no real time on this machine: " + outcome_.refused);
  }
  quick_wake_.emplace();
  go_.store(true, std::memory_order_release);
  go_.notify_all();
}

void HapticLoop::stop() {
  if (!running()) return;
  thread_.request_stop();
  thread_.join();
  thread_ = std::jthread();
  quick_wake_.reset();
}

void HapticLoop::turn_at(std::int64_t deadline_ns, bool release_hand) noexcept {
  const std::int64_t begin_ns = monotonic_ns();
  servo_.turn(clock_.now_s(), release_hand);
  const std::int64_t end_ns = monotonic_ns();
  lateness_.add_ns(begin_ns - deadline_ns);
  compute_.add_ns(end_ns - begin_ns);
}

std::int64_t HapticLoop::next_deadline_ns(std::int64_t deadline_ns) noexcept {
  const std::int64_t next_ns = deadline_ns + period_ns_;
  const std::int64_t now_ns = monotonic_ns();
  if (now_ns <= next_ns) return next_ns;
  // Those that have passed are gone: the next one that is still to come.
  const std::int64_t passed = (now_ns - next_ns) / period_ns_ + 1;
  missed_count_.fetch_add(static_cast<std::uint64_t>(passed), std::memory_order_relaxed);
  return next_ns + passed * period_ns_;
}

void HapticLoop::run(std::stop_token stop) {
  go_.wait(false, std::memory_order_acquire);
  if (stop.stop_requested()) return;
  sharpen_timers();
  prefault_stack();
  std::int64_t deadline_ns = monotonic_ns() + period_ns_;
  int left = kReleaseTurns;
  while (left > 0) {
    sleep_until(deadline_ns);
    const bool release_hand = stop.stop_requested();
    if (release_hand) --left;
    turn_at(deadline_ns, release_hand);
    deadline_ns = next_deadline_ns(deadline_ns);
  }
  servo_.release();
}

}  // namespace pellucida
