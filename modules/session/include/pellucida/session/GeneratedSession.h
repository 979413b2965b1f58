#pragma once
#include <filesystem>
#include <vector>

#include "pellucida/core_vtk/Scene.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// A session of any length in seconds, to measure what opening and seeking cost. Tables, list and head are whole: a row
/// a step, all names, sizes and checksums. Of the data files, those of each `whole_every`-th step (from the first) are
/// the scenes' own; all others hold no data: opening a session looks at their names only.
struct GeneratedSession {
  long step_count = 108000;  ///< an hour at 30 frames/s
  double frame_rate_hz = 30.0;
  long whole_every = 1000;
  SessionLayout layout = SessionLayout::kCompact;
};

/// Writes it to `folder`, which must not hold a session; the scenes come in turn. Throws UsageError, OutputError as
/// SessionWriter does, std::invalid_argument without a scene.
void generate_session(const std::filesystem::path& folder, const SessionInfo& info, const std::vector<Scene>& scenes,
                      const GeneratedSession& wanted);

}  // namespace pellucida
