#pragma once
#include <cstdint>
#include <string>
#include <type_traits>

#include "pellucida/core/PlainVector.h"

namespace pellucida {

/// The limits of an input device, as data; every force is kept within them. Hand side: m, N, s.
struct DeviceSpecification {
  std::string name;
  double max_force_N = 0.0;  ///< peak; 0: no force (mouse, keyboard)
  double max_continuous_force_N = 0.0;
  double max_stiffness_N_per_m = 0.0;  ///< of a virtual wall that remains stable
  double max_damping_N_s_per_m = 0.0;
  double physical_damping_N_s_per_m = 0.0;  ///< b of the bound b > K T / 2 + |B|; 0: not known
  double workspace_radius_m = 0.0;
  double resolution_m = 0.0;  ///< of the position
  std::string source;         ///< of the numbers
};

/// One reading of the hand. Frame H of the hand: x to the right, y up, z towards the person, origin at the middle of
/// the workspace.
struct HandSample {
  double time_s = 0.0;  ///< on the run's clock
  PlainVector3 position_m;
  PlainVector3 velocity_m_per_s;  ///< valid when `velocity_known`
  bool velocity_known = false;    ///< otherwise it is estimated from the positions
  std::uint32_t buttons = 0;      ///< bit mask of `HandButton`
};
static_assert(std::is_trivially_copyable_v<HandSample>);

/// Meaning of the buttons of any device.
enum HandButton : std::uint32_t {
  kClutch = 1,    ///< while held, the pipette stays and the hand may be moved back
  kInject = 2,    ///< deposit while held
  kRetract = 4,   ///< take the pipette out along the path
  kEmergency = 8  ///< stop everything; always wins
};

/// An input device held by the hand. `read` and `write` are called by the 1 kHz thread alone, once a tick each: they
/// neither allocate, lock, log nor throw, and return at once. Opening and closing happen elsewhere (constructor,
/// destructor).
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;
  virtual const DeviceSpecification& specification() const noexcept = 0;

  /// The hand now; false when the device is lost (the loop then releases the force and reports it). `now_s`: the run's
  /// clock.
  virtual bool read(double now_s, HandSample& sample) noexcept = 0;

  /// The force on the hand, frame H, N: finite and within the specification. False when the device is lost.
  virtual bool write(const PlainVector3& force_N) noexcept = 0;
};

/// Frame H to frame W (x right, y down, z into the scene) and back: the same half turn about x.
inline PlainVector3 world_from_hand(const PlainVector3& v) noexcept {
  return {v.x, -v.y, -v.z};
}
inline PlainVector3 hand_from_world(const PlainVector3& v) noexcept {
  return {v.x, -v.y, -v.z};
}

}  // namespace pellucida
