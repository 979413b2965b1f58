#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "pellucida/pipeline/PipelineOptions.h"
#include "pellucida/session/SessionSource.h"

namespace pellucida {

/// Adds `--from`, `--to` and `--every` to a command: which frames of a session.
void add_range_options(CLI::App& command, PlaybackOptions& playback);

/// Adds `--speed`, `--loop` and `--backwards`: how they are shown.
void add_showing_options(CLI::App& command, PlaybackOptions& playback, double& speed_ratio);

/// What a run of `source` starts from: for a session the options it was recorded with, where the command line does not
/// state others (`--profile`, `--quality`, `--detection`, `--revolve-step-deg`); else `stated` as it is.
PipelineOptions options_for(const std::string& source, const CLI::App& command, const PipelineOptions& stated);
/// The same; `is_stated`: whether an option, by its name, is stated.
PipelineOptions options_for(const std::string& source, const std::function<bool(const std::string&)>& is_stated,
                            const PipelineOptions& stated);

}  // namespace pellucida
