#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace pellucida {

/// Positions of the tip during the last second or so, one per tick: a frame shows a tip that has moved on since.
/// Nothing allocates or throws.
class TipHistory {
 public:
  void clear() noexcept { count_ = 0; }

  /// `time_s` must not precede the newest; such a position is ignored.
  void add(double time_s, const Eigen::Vector3d& tip_um) noexcept {
    if (count_ > 0 && time_s < newest().time_s) return;
    places_[count_++ & (kCapacity - 1)] = {time_s, tip_um.x(), tip_um.y(), tip_um.z()};
  }

  bool empty() const noexcept { return count_ == 0; }

  /// The tip at `time_s`, interpolated; the oldest or newest known position for a time outside. Zero while empty.
  Eigen::Vector3d at(double time_s) const noexcept {
    if (count_ == 0) return Eigen::Vector3d::Zero();
    const std::size_t oldest = count_ > kCapacity ? count_ - kCapacity : 0;
    // Bisection over the kept places: `low` is at or before the time, `high` after it.
    std::size_t low = oldest, high = count_ - 1;
    if (time_s <= place(low).time_s) return place(low).tip();
    if (time_s >= place(high).time_s) return place(high).tip();
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (place(middle).time_s <= time_s ? low : high) = middle;
    }
    const double span_s = place(high).time_s - place(low).time_s;
    const double part = span_s > 0.0 ? (time_s - place(low).time_s) / span_s : 0.0;
    return (1.0 - part) * place(low).tip() + part * place(high).tip();
  }

 private:
  struct Place {
    double time_s = 0.0, x = 0.0, y = 0.0, z = 0.0;
    Eigen::Vector3d tip() const noexcept { return {x, y, z}; }
  };
  static constexpr std::size_t kCapacity = 1024;

  const Place& place(std::size_t k) const noexcept { return places_[k & (kCapacity - 1)]; }
  const Place& newest() const noexcept { return place(count_ - 1); }

  std::array<Place, kCapacity> places_{};
  std::size_t count_ = 0;
};

}  // namespace pellucida
