#pragma once
#include <memory>
#include <string_view>

#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/microscopy/Look.h"
#include "pellucida/simulation/NeedleDrive.h"
#include "pellucida/simulation/Scenario.h"
#include "pellucida/simulation/Truth.h"
#include "pellucida/simulation/TruthLog.h"

namespace pellucida {

/// What drives the microscope.
enum class Pace {
  kAsFastAsPossible,  ///< a frame is delivered when requested: files, batches, tests, runs that pace themselves
  kWallClock          ///< a live source: frames are exposed at their own time, those not requested in time are lost
};

/// A scenario as a source of frames: a drive moves the needle, the specimen responds, the renderer draws.
/// Deterministic: the same scenario and the same motion give the same bytes. Used by one thread at a time.
class VirtualMicroscope : public FrameSource {
 public:
  /// The scenario's own motion moves the needle, as fast as possible. Throws UsageError (values that don't go together,
  /// a depth beyond the reference), InputError (a damaged resource). The look is the scenario's.
  explicit VirtualMicroscope(const Scenario& scenario);
  /// The same under another look than the scenario's.
  VirtualMicroscope(const Scenario& scenario, const Look& look);
  /// `needle` moves the needle, which another thread may command meanwhile (CommandedNeedle): it is queried at each
  /// frame's exposure. Without an end of its own the source ends after `image.duration_s`, or never if that is 0. At
  /// the wall clock the source is live: the first frame is exposed at the first `next()`, which blocks until the next
  /// one's time has come.
  VirtualMicroscope(const Scenario& scenario, std::shared_ptr<NeedleDrive> needle, Pace pace = Pace::kAsFastAsPossible);
  ~VirtualMicroscope() override;

  const SourceInfo& info() const noexcept override;
  /// The next frame; nothing after the last. `time_s` = index / frame rate.
  std::optional<Frame> next() override;
  /// Skips the next frame without drawing it, as if it had been lost; false after the last.
  bool skip();

  /// Restarts with frame 0 and a new cell: the same frames again, if the needle moves the same. False for a live
  /// source, whose time cannot be repeated.
  bool restart() override;
  /// The truth of the last frame delivered. Before the first frame: of frame 0's time, not drawn.
  const Truth& truth() const noexcept;
  const Scenario& scenario() const noexcept;
  /// The true force of the newest frames, for whoever shows it while the microscope goes on.
  std::shared_ptr<const TruthLog> truth_log() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The microscope of a shipped scenario or a JSON file; its `info().name` is "virtual:<scenario>".
/// Throws as load_scenario and the constructor.
std::unique_ptr<VirtualMicroscope> open_virtual(std::string_view scenario);

}  // namespace pellucida
