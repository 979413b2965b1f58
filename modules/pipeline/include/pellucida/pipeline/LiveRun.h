#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core/Clock.h"
#include "pellucida/core/ContactModel.h"
#include "pellucida/core/ManipulatorTrack.h"
#include "pellucida/core/PaceFigures.h"
#include "pellucida/core/PersonHint.h"
#include "pellucida/core/SharedLatest.h"
#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/pipeline/PipelineOptions.h"

namespace pellucida {

struct CellProfile;

/// Status of a live run at one moment.
struct LiveStatus {
  std::uint64_t frame_count = 0;     ///< frames that arrived
  std::uint64_t measured_count = 0;  ///< frames that went through the whole chain
  std::uint64_t skipped_count = 0;   ///< frames that a newer one overtook before they were measured
  std::uint64_t gap_count = 0;       ///< frames the source itself lost
  double tracking_ms = 0.0;          ///< newest step times
  double mechanics_ms = 0.0;
  double surface_ms = 0.0;
  double frame_age_ms = 0.0;  ///< now minus the arrival of the newest measured frame
  bool recording = false;
  std::string recording_folder;  ///< of the running or last recording; empty before the first
  std::uint64_t recorded_count = 0;
  std::uint64_t recorder_dropped_count = 0;  ///< frames recorded without their image, or lost to a fault
  std::uint64_t recorder_thinned_count = 0;  ///< frames recorded without their surface
  std::size_t waiting_note_count = 0;        ///< notes made while nothing recorded: they go into the next recording
  PaceFigures pace;                          ///< of a source that isn't live
  bool finished = false;                     ///< the source ended and all was processed
  std::optional<std::string> fault;          ///< one line, when a thread died
};

/// The chain with a thread a step: source -> tracking -> mechanics -> surface -> newest scene, recorder.
///
/// Threads: `set_contact_sink`, `start`, `stop` and the destructor belong to one controlling thread (the window's);
/// every other call may come from any thread at any time between construction and destruction. None blocks for a frame.
/// None waits for the disk but `start_recording`, `stop_recording` and `stop`, and nobody waits for those.
class LiveRun {
 public:
  /// Paced: a source that isn't live is read by the times of its frames, `speed_ratio` times as fast (above 0). Throws
  /// as `Chain` does.
  LiveRun(std::unique_ptr<FrameSource> source, PipelineOptions options, double speed_ratio = 1.0);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// Passes each measured frame's contact to `sink`, on the mechanics' thread, before the scene is published. To be
  /// called before `start`.
  void set_contact_sink(std::function<void(const ContactModel&)> sink);
  /// The run's clock: arrival times and the age of a force are on it.
  const Clock& clock() const noexcept;
  /// Subtracted from a time of the run's clock it gives the session's time (that of frames and rows): the shortest
  /// delay of a frame since the source began; 0 before the first frame.
  double session_lag_s() const noexcept;

  void start();
  /// Ends the run; a recording is closed first.
  void stop();
  /// Throws OutputError where `stop` could not close the recording whole.
  void rethrow_recording_fault() const;
  /// A paused run keeps its newest scene; a source that isn't live waits, of a live one the frames in between are not
  /// taken. The events `paused` and `resumed` say so, the latter with how many: they don't count as lost by the source.
  void set_paused(bool paused);
  bool paused() const noexcept;
  /// Restarts from the source's first frame, if the source can; false if it can't. Frame numbers and times keep rising;
  /// rows and events so far are kept.
  bool restart();
  bool can_restart() const noexcept;

  const SourceInfo& source_info() const noexcept;
  /// The kind of cell the forces are for; never changes.
  const CellProfile& profile() const noexcept;

  /// The newest measured scene, for a StageSource.
  std::shared_ptr<SharedLatest<Scene>> scenes() const noexcept;
  /// The newest frame as it arrived, not yet measured (a scene with only `frame`): for a feed that never lags.
  std::shared_ptr<SharedLatest<Scene>> frames() const noexcept;

  /// Rows measured since the one with number `first` (0 = all so far): for charts that miss nothing.
  std::vector<Measurement> measurements_since(std::size_t first) const;
  std::vector<Event> events_since(std::size_t first) const;

  /// Records from the next frame on. Throws OutputError when the folder can't be written, UsageError when it already
  /// holds a session, or a recording is running.
  void start_recording(const std::filesystem::path& folder);
  /// Ends the recording and waits until all of it is on the disk. Throws OutputError when the disk refused.
  void stop_recording();
  /// Writes the next block of the hand's recording to the running recording; true when there is none. False when the
  /// recorder has no room: to be tried again, nothing is dropped.
  bool record_hand(const Frozen<vtkPolyData>& block, double time_s);
  /// Takes a manipulator's reports, on the run's clock, from any thread: the place that they give at a frame's time
  /// goes into its row, and to the tracker. Of a frame whose source has a place for it, that one does.
  ManipulatorTrack& manipulator() noexcept;
  /// The plan that guides the hand, JSON text: written to the running recording and later ones.
  void set_plan(const std::string& plan_json);
  /// A measurement of this cell's own scale, which counts from a moment later on (`since_s` is set to that); into the
  /// running recording and later ones, with an event. An aspiration needs its modulus. Throws UsageError as
  /// `ForceObserver::set_scale_measurements`.
  void add_scale_measurement(const ScaleMeasurement& measurement);
  /// Back to the kind's scale: another cell.
  void forget_scale();
  /// What a person points at in the image: counts for the first frame measured from its time on (0: the next), whose
  /// events report it. Throws UsageError for numbers that are not finite.
  void add_hint(const PersonHint& hint);
  /// An event that does not come from a frame (a limit that acted), for the log of events and the running recording.
  void add_event(const Event& event);
  /// An operator's note, into the log of events and the running recording. False when nothing records: the note is
  /// kept, with its time, for the next recording that is started.
  bool note(const std::string& text);

  LiveStatus status() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
