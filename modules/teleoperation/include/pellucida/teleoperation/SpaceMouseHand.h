#pragma once
#include <string>

#include "pellucida/teleoperation/PolledHand.h"

namespace pellucida {

struct SpaceMouseOptions {
  double reach_m = 0.02;           ///< hand motion for the fully deflected cap
  double full_deflection = 350.0;  ///< the daemon's report there
};

/// A SpaceMouse through the daemon spacenavd (libspnav). Pushing the cap moves, turning it has no effect. It springs
/// back: use rate control with `self_centring`. First button: clutch; second: inject; third: emergency stop.
///
/// When the daemon disappears, the device is lost; when it returns, so does the device. libspnav holds one connection
/// per program.
class SpaceMouseHand final : public PolledHand {
 public:
  /// Throws DeviceError: no daemon (not installed, not running, no permission), another one is in use, or no libspnav
  /// in this build.
  explicit SpaceMouseHand(const SpaceMouseOptions& options = {});
  ~SpaceMouseHand() override;

 private:
  Reading poll(const TouchCue& cue, std::stop_token stop) override;
  void take_events();

  SpaceMouseOptions options_;
  Reading reading_;
};

/// Why no SpaceMouse can be reached, and how to correct it; empty when the daemon answers. Opens nothing.
std::string space_mouse_trouble();

/// The name of the daemon's device, or empty. Connects for a moment.
std::string space_mouse_name();

/// The version of libspnav that this was built with; empty in a build without it (PELLUCIDA_WITH_SPNAV).
std::string space_mouse_library_version();

}  // namespace pellucida
