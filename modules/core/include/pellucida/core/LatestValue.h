#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace pellucida {

/// Wait-free newest-wins slot for the 1 kHz thread: one writer, one reader, three buffers. One atomic byte packs the
/// index of the middle buffer and whether it is fresh, so a value is never torn and never goes back in time. T is
/// trivially copyable and of fixed size. No call allocates, locks or throws.
template <class T>
class LatestValue {
  static_assert(std::is_trivially_copyable_v<T>, "the real-time hand-over copies bytes");

 public:
  /// Writer thread only.
  void publish(const T& value) noexcept {
    slots_[back_] = value;
    back_ = middle_.exchange(static_cast<std::uint8_t>(back_ | kFresh), std::memory_order_acq_rel) & kIndex;
  }

  /// Reader thread only: takes over a newer value if there is one; true when it did.
  bool refresh() noexcept {
    if (!(middle_.load(std::memory_order_relaxed) & kFresh)) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return true;
  }

  /// Reader thread only: the value of the last `refresh`; a value-initialised T before the first.
  const T& value() const noexcept { return slots_[front_]; }

 private:
  static constexpr std::uint8_t kFresh = 0x80;
  static constexpr std::uint8_t kIndex = 0x03;

  std::array<T, 3> slots_{};
  alignas(64) std::uint8_t back_ = 0;
  alignas(64) std::atomic<std::uint8_t> middle_{1};
  alignas(64) std::uint8_t front_ = 2;
};

}  // namespace pellucida
