#pragma once
#include <string>

#include "pellucida/core/Expected.h"
#include "pellucida/haptics/CellStrength.h"
#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {

/// A scaling between hand and cell.
struct ScalingRequest {
  double force_scale_N_per_uN = 0.0;
  double motion_scale_um_per_m = 0.0;
  CellStrength cell;
  double period_s = 1e-3;  ///< T of the loop
  double delay_s = 0.0;    ///< further delay of the force: low-pass, filters of the motion
};

/// Why a scaling is refused.
enum class ScalingFault {
  kNoForce,     ///< the device has no force output
  kOutOfRange,  ///< a number is not finite, or not above 0
  kForce,       ///< the cell's force would be above the device's largest
  kStiffness,   ///< the cell would be stiffer at the hand than the device can render
  kDamping,     ///< the same for damping
  kPassivity    ///< b > K (T/2 + delay) + |B| is violated
};

/// The cell at the hand under an accepted scaling.
struct ScalingFigures {
  double force_N = 0.0;
  double stiffness_N_per_m = 0.0;
  double damping_N_s_per_m = 0.0;
  double damping_needed_N_s_per_m = 0.0;  ///< K (T/2 + delay) + |B|
};

struct ScalingRefusal {
  ScalingFault fault = ScalingFault::kOutOfRange;
  double value = 0.0;                         ///< the value requested, in N, N/m or N s/m
  double limit = 0.0;                         ///< the device's limit
  double nearest_force_scale_N_per_uN = 0.0;  ///< the largest accepted with that motion scale; 0: none
};

/// One line: what, how much, and what would be accepted.
std::string to_string(const ScalingRefusal& refusal);

/// Whether a device can render a scaling: with S_f, S_p the scales of force (N/uN) and motion (um/m), force, stiffness
/// and damping of the cell at the hand are F S_f, k S_f S_p and b S_f S_p; each must be within the device's limit, and
/// where the device's own damping b is known,
///     b > K (T/2 + delay) + |B|
/// (Colgate and Schenkel 1997, J. Robotic Systems 14; the delay adds to the half period of the sampling). The largest
/// stiffness stated by a maker is such a bound already. No allocation, no exception.
expected<ScalingFigures, ScalingRefusal> check_scaling(const DeviceSpecification& device,
                                                       const ScalingRequest& request) noexcept;

/// The largest force scale `check_scaling` accepts for that motion scale; 0 for a device without force.
double largest_force_scale_N_per_uN(const DeviceSpecification& device, const ScalingRequest& request) noexcept;

}  // namespace pellucida
