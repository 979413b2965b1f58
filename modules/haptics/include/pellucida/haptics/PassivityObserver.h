#pragma once
#include <Eigen/Core>

#include "pellucida/haptics/ForceGuards.h"
#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {

/// Time-domain passivity observer and controller at the hand (Hannaford and Ryu 2002, IEEE Trans. Robotics and
/// Automation 18(1)). The force is held constant from one reading to the next, so the energy the hand has put into the
/// device is exactly
///     E_n = E_{n-1} - F_{n-1} . (x_n - x_{n-1}) + b |x_n - x_{n-1}|^2 / dt,
/// the last term being the energy dissipated by the device's own friction: b as specified, or K_max T / 2, which is
/// implied by a stated largest stiffness K_max for the period T. While E >= 0 nothing generates energy. Once it falls
/// below, a damper -alpha v with alpha = -E / (dt |v|^2), at most the device's largest damping, dissipates it.
///
/// Energy put in long ago must not allow activity now: E is kept below the energy that a spring of a tenth of the
/// device's largest stiffness stores at the device's largest force.
///
/// The 1 kHz thread only. Nothing allocates, locks or throws.
class PassivityObserver {
 public:
  PassivityObserver(const DeviceSpecification& device, double period_s) noexcept;

  /// The next motion counts from here; the energy stays: after a jump or a loss of the device.
  void rebase(const Eigen::Vector3d& hand_m) noexcept;

  /// The reading of this tick, with the force written after the last one. Frame H.
  void observe(const Eigen::Vector3d& hand_m, const Eigen::Vector3d& last_force_N, double dt_s) noexcept;

  /// The damper's force for this tick: none unless the margin is negative; it sets in and fades within 10 ms. Once per
  /// tick. Frame H, N.
  Eigen::Vector3d damping_force_N(const Eigen::Vector3d& velocity_m_per_s, double dt_s) noexcept;

  /// E, J.
  double margin_J() const noexcept { return margin_J_; }
  double credited_damping_N_s_per_m() const noexcept { return credited_damping_; }

 private:
  double credited_damping_, max_damping_, largest_margin_J_;
  double margin_J_ = 0.0;
  Eigen::Vector3d hand_m_ = Eigen::Vector3d::Zero();
  Ramp alpha_part_;
  bool started_ = false;
};

}  // namespace pellucida
