#pragma once
#include <array>
#include <cstddef>
#include <mutex>
#include <optional>

namespace pellucida {

/// The true force of a virtual microscope's newest frames, to be shown beside the measured one: never a measurement,
/// and in no recording. Any thread.
class TruthLog {
 public:
  /// Frames numbered as a run numbers them: on and on, over restarts. uN, of the needle on the cell along its push.
  void add(long frame, double force_uN) {
    const std::lock_guard lock(mutex_);
    places_[static_cast<std::size_t>(frame) % places_.size()] = {frame, force_uN};
  }
  /// Nothing for a frame that was not shown, or too long ago.
  std::optional<double> force_uN(long frame) const {
    const std::lock_guard lock(mutex_);
    if (frame < 0) return std::nullopt;
    const Place& place = places_[static_cast<std::size_t>(frame) % places_.size()];
    return place.frame == frame ? std::optional(place.force_uN) : std::nullopt;
  }

 private:
  struct Place {
    long frame = -1;
    double force_uN = 0.0;
  };
  mutable std::mutex mutex_;
  std::array<Place, 256> places_;
};

}  // namespace pellucida
