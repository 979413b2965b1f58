#include "commands/AnalyzeCommand.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "commands/CommandLine.h"
#include "commands/DetectionOption.h"
#include "commands/FieldOption.h"
#include "commands/MeasureSession.h"
#include "commands/PlaybackOption.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/pipeline/AnySource.h"

namespace pellucida {
namespace {

struct AnalyzeArguments {
  std::string input;
  std::string output;
  PipelineOptions pipeline;
  SourceOptions source;
  PlaybackOptions playback{.all_frames = true};
  std::string quality = "live";
  Palpation palpation;
  double known_sigma_percent = 5.0;
  bool no_frames = false;
  int job_count = 1;
};

void analyze(const CLI::App& command, const AnalyzeArguments& arguments) {
  if (arguments.job_count < 1) {
    throw UsageError("--jobs " + std::to_string(arguments.job_count) + ": give a number of 1 or more");
  }
  PipelineOptions stated = arguments.pipeline;
  if (arguments.quality == "high") stated.tracker.quality = TrackerOptions::Quality::kHigh;
  const Palpation& palpation = arguments.palpation;
  if (palpation.known_force_uN != 0.0 || palpation.known_stiffness_uN_per_um != 0.0 ||
      palpation.indentation_um != 0.0) {
    stated.palpation = palpation;
    stated.palpation->relative_sigma = 0.01 * arguments.known_sigma_percent;
    validate(*stated.palpation);
  }
  const PipelineOptions pipeline = options_for(arguments.input, command, stated);
  const auto source = open_any_source(arguments.input, arguments.source, arguments.playback);
  const BatchResult result = measure_session(*source, pipeline, arguments.job_count, arguments.output,
                                             {.frames = !arguments.no_frames}, command_line());
  std::cout << summary(result, arguments.output);
  require_measured(result, arguments.input);
}

}  // namespace

void add_analyze_command(CLI::App& app) {
  auto arguments = std::make_shared<AnalyzeArguments>();
  CLI::App* command =
      app.add_subcommand("analyze", "measure a recording: contours, 3-D surface, forces, into a session");
  command
      ->add_option("input", arguments->input,
                   "video, folder of images, multi-page TIFF, still, session, or virtual[:SCENARIO]")
      ->required();
  command->add_option("--output", arguments->output, "folder of the session to write")->required();
  command
      ->add_option("--profile", arguments->pipeline.profile,
                   "cell profile, by name or file; of a session: the recorded one, and so for the options that follow")
      ->capture_default_str();
  command->add_option("--pixel-size-um", arguments->source.pixel_size_um, "edge of a pixel, um (default: metadata)");
  command->add_option("--fps", arguments->source.frame_rate_hz, "frames a second (default: metadata)");
  command->add_option("--max-megapixels", arguments->source.most_megapixels, "refuse larger images, megapixels")
      ->capture_default_str();
  command
      ->add_option("--revolve-step-deg", arguments->pipeline.revolve_step_deg,
                   "angle between the meridians of the 3-D mesh, degrees, a divisor of 360")
      ->capture_default_str();
  command
      ->add_option("--quality", arguments->quality,
                   "live: as fast as the camera; high: the cell is found with level sets as well, for recordings where "
                   "time does not matter")
      ->check(CLI::IsMember({"live", "high"}))
      ->capture_default_str();
  add_detection_option(*command, arguments->pipeline.tracker.detection);
  command->add_option("--known-force-uN", arguments->palpation.known_force_uN,
                      "force measured independently in a small push beforehand, uN: scales all forces to this cell");
  command->add_option("--known-stiffness-uN-per-um", arguments->palpation.known_stiffness_uN_per_um,
                      "instead of a force: the stiffness measured independently, uN/um");
  command->add_option("--at-indentation-um", arguments->palpation.indentation_um, "the depth of that push, um");
  command
      ->add_option("--known-force-sigma-percent", arguments->known_sigma_percent,
                   "standard deviation of the known force or stiffness, %")
      ->check(number_in(above(0.0, 100.0)))
      ->capture_default_str();
  add_range_options(*command, arguments->playback);
  command->add_flag("--no-frames", arguments->no_frames, "omit the images from the session");
  command->add_option("--jobs", arguments->job_count, "1: one loop; more: the steps in parallel, with the same numbers")
      ->capture_default_str();
  command->callback([command, arguments] { analyze(*command, *arguments); });
}

}  // namespace pellucida
