#pragma once
#include <string>

#include "pellucida/haptics/Pipette.h"

namespace pellucida {

/// The specification of a manipulator. Frame W, um.
struct ManipulatorSpecification {
  std::string name;
  PlainVector3 lower_um, upper_um;  ///< travel limits
  double max_speed_um_per_s = 0.0;
  double resolution_um = 0.0;  ///< of a commanded position
  double rate_Hz = 0.0;        ///< commands accepted per second
  bool can_inject = false;     ///< it acts on `PipetteCommand::inject`
  std::string source;          ///< of the numbers
};

/// Moves the injection pipette. One thread at a time, never the 1 kHz thread: a call may wait for the device, up to a
/// deadline of its own.
class Manipulator {
 public:
  virtual ~Manipulator() = default;

  /// Throws DeviceError: which device, what failed, how to correct it. A manipulator that is open stays open.
  virtual void open() = 0;

  /// Stops the motion if it can, and releases the device. Never fails.
  virtual void close() noexcept = 0;
  virtual bool is_open() const noexcept = 0;

  /// Valid while open.
  virtual const ManipulatorSpecification& specification() const noexcept = 0;

  /// Executes the newest command; `now_s` on the run's clock. A target beyond the travel is clamped to its edge and
  /// reported as `at_limit`. Throws DeviceError when the device is lost: it is then closed, and `open` may be tried
  /// again.
  virtual void command(const PipetteCommand& command, double now_s) = 0;

  /// Its present state. Throws as `command`.
  virtual PipetteState state(double now_s) = 0;
};

}  // namespace pellucida
