#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "pellucida/haptics/LimitEvent.h"

namespace pellucida {

/// Turns "this limit acts in this tick" into events: one when it begins, one when it hasn't acted for 0.1 s, so that a
/// limit that flickers at 1 kHz is one event. Nothing allocates or throws.
class LimitLog {
 public:
  static constexpr std::size_t kKindCount = static_cast<std::size_t>(LimitKind::kCount);

  /// Events of one tick.
  struct Changes {
    std::array<LimitEvent, kKindCount> events{};
    std::size_t count = 0;
  };

  /// Records what the limit compares, for its event.
  void note(LimitKind kind, double value, double limit) noexcept;

  /// The limits that act at `now_s`, as a mask; call once a tick.
  Changes update(double now_s, std::uint32_t acting) noexcept;

 private:
  struct Kind {
    bool begun = false;
    double last_s = 0.0, value = 0.0, limit = 0.0;
  };
  std::array<Kind, kKindCount> kinds_{};
};

/// The limits that act in one tick, collected on the way through it. Must not outlive the log.
class ActingLimits {
 public:
  explicit ActingLimits(LimitLog& log) noexcept : log_(log) {}

  /// This limit acts, and what it compares.
  void add(LimitKind kind, double value = 0.0, double limit = 0.0) noexcept {
    mask_ |= limit_bit(kind);
    log_.note(kind, value, limit);
  }
  /// These act; what they compare follows by `explain`.
  void add(std::uint32_t mask) noexcept { mask_ |= mask; }
  /// What a limit compares, where it acts.
  void explain(LimitKind kind, double value, double limit) noexcept {
    if ((mask_ & limit_bit(kind)) != 0) log_.note(kind, value, limit);
  }
  std::uint32_t mask() const noexcept { return mask_; }

 private:
  LimitLog& log_;
  std::uint32_t mask_ = 0;
};

}  // namespace pellucida
