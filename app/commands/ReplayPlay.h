#pragma once
#include <string>

#include "pellucida/pipeline/PipelineOptions.h"
#include "pellucida/session/SessionSource.h"

namespace pellucida {

/// Plays a session through the live chain, a thread for each step, at the pace of its frames; prints how well the time
/// was kept and what was measured.
void play_session(const std::string& session, const PipelineOptions& pipeline, const PlaybackOptions& playback,
                  double speed_ratio);

/// Measures a session frame by frame as the person at the terminal asks: a line for each step from standard input.
void step_through_session(const std::string& session, const PipelineOptions& pipeline, const PlaybackOptions& playback);

}  // namespace pellucida
