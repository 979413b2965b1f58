#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "pellucida/core/Event.h"
#include "pellucida/core/Measurement.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// Reads a session folder, closed or interrupted. Opening reads the head, the two tables and the names of the files;
/// the data files are read one step at a time, each held against its checksum and its meaning; a session's files may be
/// anybody's. Lines of the tables that can't be read are skipped (`check_session`
/// names them). One thread at a time; the scenes returned may be used on any thread.
class SessionReader {
 public:
  /// Throws InputError when the folder is missing or holds no readable session.
  explicit SessionReader(const std::filesystem::path& folder);
  ~SessionReader();
  SessionReader(SessionReader&&) noexcept;
  SessionReader& operator=(SessionReader&&) noexcept;

  const std::filesystem::path& folder() const noexcept;
  const SessionInfo& info() const noexcept;
  /// Wall clock at the start, UTC, as `session.json` states it; empty where it states none.
  const std::string& created() const noexcept;
  /// True when the session was closed; false after a crash, repaired or not, and while it is still being written.
  bool complete() const noexcept;
  /// True when `session.json` was changed after it was written: its calibration and profile may not be those of the
  /// run.
  bool head_changed() const noexcept;
  /// Lines of the two tables that were skipped because they can't be read or were changed.
  std::size_t skipped_row_count() const noexcept;
  /// The counts `session.json` states.
  const SessionCounts& stated_counts() const noexcept;

  /// One entry a row of `measurements.csv`, in its order.
  const std::vector<SessionStep>& steps() const noexcept;
  /// One entry a step.
  const std::vector<Measurement>& measurements() const noexcept;
  const std::vector<Event>& events() const noexcept;
  /// Blocks of the recording of the hand, in order; 0 when there was none.
  std::size_t hand_block_count() const noexcept;
  /// The recording of the hand, block `block` (0-based). Throws InputError when the file can't be read,
  /// std::out_of_range for a block that isn't there.
  Frozen<vtkPolyData> load_hand(std::size_t block) const;

  /// Reads the parts of step `step` (0-based) that are present. `arrival_s` of the scene is the step's time; `events`
  /// are those stamped within the step (from its time up to the next one's); `observation` stays empty. Throws
  /// InputError when a file can't be read, std::out_of_range for a step that isn't there.
  Scene load(std::size_t step) const;

  /// A step's image alone, a new object; null when the step lacks it. Errors as above.
  vtkSmartPointer<vtkImageData> read_image(std::size_t step) const;

  /// One part alone: the surface, the membranes or the tools; an empty handle when the step lacks it. Errors as above.
  Frozen<vtkPolyData> load(std::size_t step, SessionPart part) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
