#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// A set of a session's frames, as stretches of frames recorded one after another.
class FrameStretches {
 public:
  /// The next recorded frame: in the set, or not.
  void add(long frame_index, bool in_set);
  bool holds(long frame_index) const noexcept;
  /// First and last frame of each, both included, ascending.
  const std::vector<std::pair<long, long>>& stretches() const noexcept { return stretches_; }
  static FrameStretches of(std::vector<std::pair<long, long>> stretches);

 private:
  std::vector<std::pair<long, long>> stretches_;
  bool open_ = false;  // the last stretch may go on
};

/// Which frames' evidence a session's numbers come from.
struct FramesUsed {
  FrameStretches tracked;        ///< went through tracking
  FrameStretches measured;       ///< and through mechanics: all that the forces depend on
  std::vector<long> run_starts;  ///< frames at which a source began anew, and with it all memory
};

/// As `session.json` states it; nothing for a session of an earlier version. Throws InputError for a value of a wrong
/// type.
std::optional<FramesUsed> frames_used_of(const SessionInfo& info);

}  // namespace pellucida
