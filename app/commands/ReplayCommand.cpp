#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "commands/CommandLine.h"
#include "commands/DetectionOption.h"
#include "commands/Interrupt.h"
#include "commands/PlaybackOption.h"
#include "commands/ReplayPlay.h"
#include "commands/ReplayVariants.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Progress.h"
#include "pellucida/pipeline/Counterfactual.h"
#include "pellucida/pipeline/RunProvenance.h"

namespace pellucida {
namespace {

struct ReplayArguments {
  std::string session;
  std::string output;
  std::vector<std::string> profiles;
  std::vector<std::string> changes;
  std::string rerun = "auto";
  PipelineOptions pipeline;
  std::string quality = "live";
  PlaybackOptions playback;
  double speed_ratio = 1.0;
  bool step = false;
  bool keep_frames = false;
  bool tables_only = false;
  int job_count = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
};

/// What runs again: what was asked for; else the mechanics alone, where the recording holds all they need and nothing
/// before them changes.
Rerun choose_rerun(const CLI::App& command, const ReplayArguments& arguments, const SessionReader& session) {
  if (arguments.rerun == "tracking") return Rerun::kTracking;
  const bool changes_tracking =
      command.count("--quality") + command.count("--detection") > 0 || arguments.playback.pixel_size_um.has_value();
  if (arguments.rerun == "mechanics") {
    if (changes_tracking) {
      throw UsageError(
          "--rerun mechanics takes the recorded contours; leave out --quality, --detection and "
          "--pixel-size-um, or give --rerun tracking");
    }
    return Rerun::kMechanics;
  }
  return !changes_tracking && has_observations(session) ? Rerun::kMechanics : Rerun::kTracking;
}

/// Without the sign of a zero, and of what the nine digits of a table make of equal numbers.
double as_printed(double value) {
  constexpr double kDigits = 1e4;
  return std::round(kDigits * value) / kDigits + 0.0;
}

void print_table(const CounterfactualResult& result) {
  std::size_t width = 7;
  for (const VariantResult& variant : result.variants) width = std::max(width, variant.name.size());
  const int column = static_cast<int>(width);
  std::printf("%-*s  %10s  %10s  %8s  %10s  %14s  %10s  %12s\n", column, "variant", "peak uN", "recorded", "ratio",
              "RMS uN", "largest uN", "states", "equal rows");
  for (const VariantResult& variant : result.variants) {
    const ChangeFigures& c = variant.changes;
    std::printf("%-*s  %10.3f  %10.3f  %8.4f  %10.4f  %+14.4f  %10d  %5d / %d\n", column, variant.name.c_str(),
                c.peak_force_uN, c.recorded_peak_force_uN, c.force_ratio, c.force_rms_uN,
                as_printed(c.largest_force_uN), c.state_change_count, c.equal_row_count, c.frame_count);
  }
}

void write_changes(const CounterfactualResult& result, const std::filesystem::path& file) {
  OutputFile output(file, OutputFile::Link::kReplace);
  output.add(change_header());
  for (const VariantResult& variant : result.variants) output.add(to_csv(variant.name, variant.changes));
  output.finish();
}

void measure_again(const CLI::App& command, const ReplayArguments& arguments, const PipelineOptions& pipeline) {
  const std::filesystem::path output = arguments.output;
  const std::filesystem::path table = output / "changes.csv";
  if (std::filesystem::exists(table)) {
    throw UsageError(table.string() + ": already there, and never overwritten; choose another folder");
  }
  const SessionReader session(arguments.session);
  CounterfactualOptions options;
  options.rerun = choose_rerun(command, arguments, session);
  options.pipeline = pipeline;
  options.playback = arguments.playback;
  options.keep_frames = arguments.keep_frames;
  options.tables_only = arguments.tables_only;
  options.job_count = arguments.job_count;
  options.command_line = command_line();
  std::vector<CellProfile> profiles;
  for (const std::string& name : arguments.profiles) profiles.push_back(load_profile(name));
  const CellProfile recorded = profile_of(pipeline);
  const auto variants = make_variants(recorded, profiles, arguments.changes, output);

  CounterfactualResult result;
  {
    const InterruptScope interrupt;
    Progress progress("replay, frame");
    options.stopped = [] { return interrupted() != 0; };
    options.progress = [&](long done, std::optional<long> all) { progress.update(done, all); };
    result = run_counterfactual(arguments.session, options, variants);
  }
  write_changes(result, table);
  const int frame_count = result.variants.front().changes.frame_count;
  std::printf(
      "replay   %d frames, %s, %zu %s, %.1f s\n", frame_count,
      options.rerun == Rerun::kTracking ? "tracked again from the images" : "mechanics alone, on the recorded contours",
      result.variants.size(), result.variants.size() == 1 ? "variant" : "variants", result.elapsed_s);
  print_table(result);
  if (result.absent_count > 0) {
    std::printf("missing  %ld frames without what they are measured from; the first: %s\n", result.absent_count,
                result.first_absence.c_str());
  }
  if (result.frames_before_recording > 0) {
    std::printf(
        "note     the run had seen %ld frames before the recording began; its steps remembered them, a replay "
        "can't\n",
        result.frames_before_recording);
  }
  std::printf("changes  %s\n", table.string().c_str());
  for (const VariantResult& variant : result.variants) std::printf("session  %s\n", variant.folder.string().c_str());
}

void replay(const CLI::App& command, const ReplayArguments& arguments) {
  PipelineOptions stated = arguments.pipeline;
  if (arguments.quality == "high") stated.tracker.quality = TrackerOptions::Quality::kHigh;
  if (!is_session(arguments.session)) {
    throw InputError(arguments.session + ": no session (a folder with a session.json); check the path");
  }
  if (!arguments.profiles.empty()) stated.profile = arguments.profiles.front();
  PipelineOptions pipeline = options_for(arguments.session, command, stated);
  if (!arguments.output.empty()) {
    if (command.count("--speed") + command.count("--step") > 0) {
      throw UsageError("--output measures as fast as it can; leave out --speed and --step, or --output");
    }
    // The table compares with the recorded profile, whatever the variants have.
    if (!arguments.profiles.empty()) {
      pipeline.given_profile = recorded_options(SessionReader(arguments.session).info()).given_profile;
    }
    measure_again(command, arguments, pipeline);
    return;
  }
  if (!arguments.changes.empty() || arguments.profiles.size() > 1 || arguments.rerun != "auto") {
    throw UsageError("--vary, --rerun and several profiles write sessions; give --output");
  }
  if (arguments.step) {
    step_through_session(arguments.session, pipeline, arguments.playback);
  } else {
    play_session(arguments.session, pipeline, arguments.playback, arguments.speed_ratio);
  }
}

}  // namespace

void add_replay_command(CLI::App& app) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command = app.add_subcommand(
      "replay",
      "a recorded session again: with --output measured again, with the same or other parameters, and compared; "
      "without, played through the live steps at its own pace");
  command->add_option("SESSION", arguments->session, "folder of the session")->required();
  command->add_option("--output", arguments->output,
                      "folder of the session to write; of several variants: a folder with a session each, and "
                      "changes.csv");
  command
      ->add_option("--profile", arguments->profiles,
                   "cell profile, by name or file, instead of the recorded one; several: a variant each")
      ->allow_extra_args(false);
  command
      ->add_option("--vary", arguments->changes,
                   "KEY=VALUE,VALUE,...: a number of the cell profile, a variant for each value; several: all "
                   "combinations. young_modulus_kPa is the modulus that forces are computed with")
      ->allow_extra_args(false);
  command
      ->add_option("--rerun", arguments->rerun,
                   "what runs again: tracking: everything, from the images; mechanics: the forces alone, from the "
                   "recorded contours; auto: the mechanics where that gives the same")
      ->check(CLI::IsMember({"auto", "tracking", "mechanics"}))
      ->capture_default_str();
  command->add_option("--quality", arguments->quality, "of tracking, live or high (default: as recorded)")
      ->check(CLI::IsMember({"live", "high"}));
  add_detection_option(*command, arguments->pipeline);
  command->add_option("--revolve-step-deg", arguments->pipeline.revolve_step_deg,
                      "angle between the meridians of the 3-D mesh, degrees, a divisor of 360 (default: as recorded)");
  command->add_option("--pixel-size-um", arguments->playback.pixel_size_um,
                      "edge of a pixel, um (default: as recorded)");
  command->add_flag("--all-frames", arguments->playback.all_frames,
                    "measure every frame, also those the recorded run had no time for");
  command->add_flag("--keep-frames", arguments->keep_frames,
                    "write the images too (default: the recorded session holds them)");
  command->add_flag("--tables-only", arguments->tables_only,
                    "write rows, events and tables, but no surfaces and contours: twice as fast");
  command->add_option("--jobs", arguments->job_count, "variants at work at the same time")->capture_default_str();
  add_range_options(*command, arguments->playback);
  add_showing_options(*command, arguments->playback, arguments->speed_ratio);
  command->add_flag("--step", arguments->step, "frame by frame: Enter for the next, b for the one before, q to end");
  command->callback([command, arguments] { replay(*command, *arguments); });
}

}  // namespace pellucida
