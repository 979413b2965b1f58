#pragma once
#include <Eigen/Core>

#include "pellucida/haptics/ForceGuards.h"
#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {

/// The link between the hand and the pipette's proxy. Hand side. Trivially copyable.
struct CouplingSettings {
  double stiffness_N_per_m = 200.0;
  double damping_N_s_per_m = 0.5;
  double width_um = 2.0;     ///< lag over which the damping sets in
  double max_force_N = 1.5;  ///< of the link alone
};

/// Spring and damper between where the hand wants the tip and the proxy, the position commanded to the pipette. The
/// proxy follows the hand exactly while nothing holds it, and the link is slack; where speed, force, depth or a fixture
/// hold the proxy back the link pulls the hand. Beside it, the contact force as felt by the hand.
///
/// Part s (0..1) of a small motion of the hand moves the proxy, which feels the cell (stiffness K_cell at the hand),
/// the rest 1 - s stretches the link: K = s K_cell + (1 - s) K_link, never above the larger of the two. So keeping each
/// below the device's largest stiffness keeps their combination below it too.
///
/// The 1 kHz thread only. Nothing allocates, locks or throws.
class VirtualCoupling {
 public:
  /// Stiffness, damping and force are limited to what the device can render.
  VirtualCoupling(const CouplingSettings& settings, const DeviceSpecification& device) noexcept;
  void set(const CouplingSettings& settings) noexcept;

  /// The link's force on the hand, frame W, N: K (proxy - wanted) / S + B w (their velocities' difference) / S with
  /// S = `scale_um_per_m` (above 0) and w growing from 0 to 1 over the width.
  Eigen::Vector3d force_N(const Eigen::Vector3d& proxy_um, const Eigen::Vector3d& wanted_um,
                          const Eigen::Vector3d& relative_velocity_um_per_s, double scale_um_per_m) const noexcept;

  /// The force scale of this tick: the one set, reduced where the contact (`stiffness_uN_per_um`) would be stiffer at
  /// the hand than the device can render. It falls within 0.1 s and returns within 1 s.
  double force_scale_N_per_uN(double wanted_N_per_uN, double stiffness_uN_per_um, double scale_um_per_m,
                              double dt_s) noexcept;

  /// True while the force scale is below the one set.
  bool scaled_down() const noexcept { return part_.value() < 1.0 - 1e-6; }

 private:
  CouplingSettings settings_;
  double device_force_N_, device_stiffness_N_per_m_, device_damping_N_s_per_m_;
  Ramp part_{1.0};
};

}  // namespace pellucida
