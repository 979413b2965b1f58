#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/pipeline/BatchRun.h"
#include "pellucida/session/SessionInfo.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {

/// What goes into a session beside its frames, while it is written; either may be empty.
struct SessionAddition {
  std::function<void(SessionWriter&, const Scene&)> after_frame;  ///< after each frame was written
  std::function<void(SessionWriter&)> at_end;                     ///< after the last one, before the session is closed
};

/// Measures every frame of `source` into a session folder, with progress on a terminal, and closes the session whatever
/// happens. Throws OutputError or UsageError about the folder, UsageError or InputError about the profile.
/// An input that broke on the way is in the result; the session holds what came before.
BatchResult measure_session(FrameSource& source, const PipelineOptions& pipeline, int job_count,
                            const std::filesystem::path& folder, const SessionOptions& session_options,
                            const std::string& command_line, const SessionAddition& addition = {});

/// What was found, a line each: frames by state, profile, peak force with its interval, what speaks against it, what
/// other models say, cell, speed, session.
std::string summary(const BatchResult& result, const std::filesystem::path& folder);

/// Rethrows what broke the input; throws NothingMeasuredError when no frame showed a cell.
void require_measured(const BatchResult& result, const std::string& input);

}  // namespace pellucida
