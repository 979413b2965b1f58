#include "commands/PlaybackOption.h"

#include "commands/FieldOption.h"
#include "commands/Versions.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {
namespace {

constexpr double kMostCount = 1e9;  // frames to leave out, loops

}  // namespace

void add_range_options(CLI::App& command, PlaybackOptions& playback) {
  command.add_option("--from", playback.from_s, "of a session: first time, s (default: its beginning)")
      ->check(number_in({}));
  command.add_option("--to", playback.to_s, "of a session: last time, s (default: its end)")->check(number_in({}));
  command.add_option("--every", playback.every, "of a session: each so many-th frame")
      ->check(number_in({1.0, kMostCount}))
      ->capture_default_str();
}

void add_showing_options(CLI::App& command, PlaybackOptions& playback, double& speed_ratio) {
  command.add_option("--speed", speed_ratio, "of a recording: times its own speed, 0.01 to 100")
      ->check(number_in({0.01, 100.0}))
      ->capture_default_str();
  command.add_option("--loop", playback.loop_count, "of a session: how often; 0: without an end")
      ->check(number_in({0.0, kMostCount}))
      ->capture_default_str();
  command.add_flag("--backwards", playback.backwards,
                   "of a session: from the last frame to the first, as a film in reverse");
}

PipelineOptions options_for(const std::string& source, const CLI::App& command, const PipelineOptions& stated) {
  const auto is_stated = [&](const std::string& name) {
    const CLI::Option* option = command.get_option_no_throw(name);
    return option && option->count() > 0;
  };
  return options_for(source, is_stated, stated);
}

PipelineOptions options_for(const std::string& source, const std::function<bool(const std::string&)>& is_stated,
                            const PipelineOptions& stated) {
  PipelineOptions options = stated;
  if (is_session(source)) {
    options = recorded_options(SessionReader(source).info());
    if (is_stated("--profile")) {
      options.given_profile.reset();
      options.profile = stated.profile;
    }
    if (is_stated("--quality")) options.tracker.quality = stated.tracker.quality;
    if (is_stated("--detection")) options.tracker.detection = stated.tracker.detection;
    if (is_stated("--revolve-step-deg")) options.revolve_step_deg = stated.revolve_step_deg;
    if (!stated.scale_measurements.empty()) options.scale_measurements = stated.scale_measurements;
  }
  options.hints = stated.hints;
  options.versions = library_versions();
  return options;
}

}  // namespace pellucida
