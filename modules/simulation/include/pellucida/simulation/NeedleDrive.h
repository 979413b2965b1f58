#pragma once
#include <optional>

#include "pellucida/core/PlainVector.h"
#include "pellucida/simulation/NeedleScript.h"
#include "pellucida/simulation/SpecimenContact.h"
#include "pellucida/simulation/VirtualSpecimen.h"

namespace pellucida {

/// The needle at one moment, as set by its drive. Frame W as it was before the stage moved: the stage carries cell,
/// holder and needle.
struct NeedleCommand {
  PlainVector3 tip_um;             ///< z out of the image plane, into the scene
  PlainVector3 velocity_um_per_s;  ///< of the tip
  double expelled_pL = 0.0;        ///< all that the needle has expelled so far
  /// The tip moves straight along the configuration's own line, this far past the resting membrane, um.
  std::optional<double> straight_depth_um;
  /// The cell's response, if the drive has asked for it itself, more often than there are frames.
  std::optional<SpecimenMoment> moment;
};

/// What moves the virtual microscope's needle. The microscope asks at each frame, for the frame's exposure time; the
/// needle's direction is the scenario's.
class NeedleDrive {
 public:
  virtual ~NeedleDrive() = default;

  /// The needle at `time_s` of the microscope's time. Called by the microscope's thread; times rise until `restart`.
  virtual NeedleCommand at(double time_s) = 0;
  /// Restarts, with a new cell.
  virtual void restart() = 0;
  /// When the motion has ended; nothing if it never ends.
  virtual std::optional<double> duration_s() const noexcept = 0;
};

/// The scenario's own motion: straight in, hold, and out; also in depth, if it says so.
class ScriptedNeedle : public NeedleDrive {
 public:
  ScriptedNeedle(const Scenario& scenario, const VirtualSpecimen& specimen);
  NeedleCommand at(double time_s) override;
  void restart() override {}
  std::optional<double> duration_s() const noexcept override { return script_.duration_s(); }

 private:
  NeedleScript script_;
  SpecimenForce force_;
  double offset_um_, out_of_plane_um_, out_of_plane_time_s_;
};

}  // namespace pellucida
