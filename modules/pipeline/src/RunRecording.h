#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "Recorder.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/Event.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// What a recording says about frames that are not in it whole.
inline constexpr const char* kDropPolicy =
    "Every frame has its row. A frame that a newer one overtook before it could be measured keeps its image; its row "
    "has an empty state and no numbers (events unmeasured). As the memory set aside for what waits to be written "
    "fills, frames lose their surface first (events thinned), then their image (events dropped), and at last their "
    "contours and tools.";

/// What is known of a run's recordings at one moment.
struct RecordingStatus {
  bool recording = false;
  std::string folder;                ///< of the running or last recording; empty before the first
  std::uint64_t recorded_count = 0;  ///< frames, in that recording
  std::uint64_t dropped_count = 0;   ///< of those, without their image, or lost to a fault
  std::uint64_t thinned_count = 0;   ///< of those, without their surface
  std::size_t waiting_note_count = 0;
  std::optional<std::string> fault;
};

/// The recordings of one run, one after the other. All calls may come from any thread; only `start` and `stop` wait for
/// the disk, and nobody waits for them but another `start` or `stop`.
class RunRecording {
 public:
  /// `clock` must outlive the recording.
  explicit RunRecording(const Clock& clock) : clock_(clock) {}

  /// Begins a recording with the plan, the notes that waited for it and `started`. Throws OutputError when the folder
  /// can't be written, UsageError when it holds a session already or a recording is running.
  void start(const std::filesystem::path& folder, SessionInfo info, const Event& started);
  /// Ends the recording that is running, if one is, with `stopped`. Throws OutputError when the disk refused.
  void stop(const Event& stopped);

  /// Of a running recording; without one these do nothing. See Recorder.
  void announce(const Scene& scene);
  void settle(const Scene& scene);
  void event(const Event& event);
  bool hand(const Frozen<vtkPolyData>& block, double time_s);

  /// Into the running recording and those to come.
  void set_plan(const std::string& plan_json);
  void set_palpation(const std::string& palpation_json);
  /// Into the running recording alone.
  void set_clocks(const std::string& clocks_json);
  /// Into the running recording; without one it waits for the next, and the answer is false.
  bool note(const Event& note);

  RecordingStatus status() const;

 private:
  const Clock& clock_;
  std::mutex control_mutex_;  // held by `start` and `stop`, the disk's time included; before mutex_
  mutable std::mutex mutex_;  // held for moments
  std::unique_ptr<Recorder> recorder_;
  std::vector<Event> waiting_notes_;
  std::string plan_json_, palpation_json_;
  std::string folder_;
  std::uint64_t recorded_count_ = 0;  // of the last recording
  std::uint64_t dropped_count_ = 0;
  std::uint64_t thinned_count_ = 0;
};

}  // namespace pellucida
