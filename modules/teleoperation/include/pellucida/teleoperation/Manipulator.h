#pragma once
#include <string>

#include "pellucida/haptics/Pipette.h"

namespace pellucida {

/// What a manipulator can do, as data. Frame W, um.
struct ManipulatorSpecification {
  std::string name;
  PlainVector3 lower_um, upper_um;  ///< travel limits
  double max_speed_um_per_s = 0.0;
  double resolution_um = 0.0;  ///< of a commanded position
  double rate_Hz = 0.0;        ///< commands a second it takes
  bool can_inject = false;     ///< it acts on `PipetteCommand::inject`
  std::string source;          ///< of the numbers
};

/// What moves the injection pipette. One thread at a time, never the 1 kHz thread: a call may wait for the device, but
/// only up to a deadline of its own.
class Manipulator {
 public:
  virtual ~Manipulator() = default;

  /// Throws DeviceError: which device, what failed, how to mend it. A manipulator that is open stays open.
  virtual void open() = 0;

  /// Stops the motion where it can, and lets the device go. Never fails.
  virtual void close() noexcept = 0;
  virtual bool is_open() const noexcept = 0;

  /// Valid while open.
  virtual const ManipulatorSpecification& specification() const noexcept = 0;

  /// Goes where the newest command says; `now_s` on the run's clock. A target beyond the travel is taken to its edge
  /// and told as `at_limit`. Throws DeviceError when the device is lost: it's closed then, and `open` may be tried
  /// again.
  virtual void command(const PipetteCommand& command, double now_s) = 0;

  /// Where it is now. Throws as `command`.
  virtual PipetteState state(double now_s) = 0;
};

}  // namespace pellucida
