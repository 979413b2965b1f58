#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {

/// Speed from positions by the first-order adaptive window (Janabi-Sharifi, Hayward, Chen 2000, IEEE Trans. Control
/// Systems Technology 8(6)): of the last 16 positions, the longest run that one straight line explains to within the
/// resolution. Fast motion is reported at once, slow motion without the noise of the encoder's steps.
class HandVelocity {
 public:
  /// `resolution_m` >= 0; 0: 1e-5 m.
  explicit HandVelocity(double resolution_m) noexcept;
  void clear() noexcept { count_ = 0; }

  /// The speed at this reading, m/s; zero for the first. `time_s` must grow; a reading that is not later changes
  /// nothing.
  Eigen::Vector3d update(double time_s, const Eigen::Vector3d& position_m) noexcept;

 private:
  static constexpr std::size_t kCapacity = 16;
  struct Reading {
    double time_s = 0.0;
    double axis_m[3] = {0.0, 0.0, 0.0};
  };
  const Reading& back(std::size_t k) const noexcept { return readings_[(count_ - 1 - k) & (kCapacity - 1)]; }
  double axis_speed(int axis) const noexcept;

  double resolution_m_;
  std::array<Reading, kCapacity> readings_{};
  std::size_t count_ = 0;
};

/// The check of a reading before it is used.
enum class HandReading { kGood, kNotFinite, kJump };

/// Accepts only readings a hand can make: finite, and no further from the previous one than `max_speed_m_per_s` and a
/// millimetre allow. After a jump the new position is the reference. The 1 kHz thread only; nothing allocates or
/// throws.
class HandGuard {
 public:
  HandReading check(const HandSample& sample, double dt_s, double max_speed_m_per_s) noexcept;
  void clear() noexcept { known_ = false; }

 private:
  Eigen::Vector3d last_m_ = Eigen::Vector3d::Zero();
  double since_s_ = 0.0;  ///< time since the last good reading
  bool known_ = false;
};

}  // namespace pellucida
