#pragma once
#include <atomic>
#include <chrono>

namespace pellucida {

/// A source of time: seconds, monotonic, 0 at the session's start. Safe to read from any thread.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual double now_s() const noexcept = 0;
};

/// The machine's monotonic clock, 0 at construction.
class SteadyClock final : public Clock {
 public:
  double now_s() const noexcept override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Follows the stamps of a recording: time is the stamp of the newest frame delivered. Never goes back.
class RecordedClock final : public Clock {
 public:
  double now_s() const noexcept override { return now_s_.load(std::memory_order_acquire); }

  /// Moves to `time_s`; an earlier stamp is ignored.
  void follow(double time_s) noexcept {
    double seen = now_s_.load(std::memory_order_relaxed);
    while (time_s > seen && !now_s_.compare_exchange_weak(seen, time_s, std::memory_order_acq_rel)) {
    }
  }

 private:
  std::atomic<double> now_s_{0.0};
};

/// A clock that a test sets.
class ManualClock final : public Clock {
 public:
  double now_s() const noexcept override { return now_s_.load(std::memory_order_acquire); }
  void set(double time_s) noexcept { now_s_.store(time_s, std::memory_order_release); }
  void advance(double dt_s) noexcept { set(now_s() + dt_s); }

 private:
  std::atomic<double> now_s_{0.0};
};

}  // namespace pellucida
