#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>

#include "commands/AnalyzeBatch.h"
#include "commands/CommandLine.h"
#include "commands/DetectionOption.h"
#include "commands/FieldOption.h"
#include "commands/MeasureSession.h"
#include "commands/PlaybackOption.h"
#include "pellucida/batch/RecordingList.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/identification/Aspiration.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/pipeline/AnySource.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "pellucida/session/Sha256.h"

namespace pellucida {
namespace {

struct AnalyzeArguments {
  BatchArguments batch;  ///< inputs, output, jobs of a single one too
  PipelineOptions pipeline;
  SourceOptions source;
  PlaybackOptions playback{.all_frames = true};
  std::string quality = "live";
  std::map<std::string, std::optional<double>> scale;  ///< numbers of `ScaleMeasurement` by key
  bool no_frames = false;
};

constexpr const char* kBatchGroup = "More than one recording";

// The options of each recording as they were given, for the program that analyses one alone.
std::vector<std::string> options_of_each(const CLI::App& command) {
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || option->get_positional() || option->get_group() == kBatchGroup || name == "--output" ||
        name == "--jobs") {
      continue;
    }
    const bool is_flag = option->get_items_expected_max() == 0;
    for (const std::string& value : option->results()) options.push_back(is_flag ? name : name + '=' + value);
  }
  return options;
}

void analyze(const CLI::App& command, const AnalyzeArguments& arguments) {
  const std::string& input = arguments.batch.inputs.front();
  const bool is_batch = arguments.batch.inputs.size() > 1 || is_batch_folder(input);
  if (arguments.batch.job_count < 1) {
    throw UsageError("--jobs " + std::to_string(arguments.batch.job_count) + ": give a number of 1 or more");
  }
  PipelineOptions stated = arguments.pipeline;
  if (arguments.quality == "high") stated.tracker.quality = TrackerOptions::Quality::kHigh;
  ScaleMeasurement given;
  for (const auto& [key, value] : arguments.scale) {
    if (value) *std::get<double*>(fields_of(given).find(key)->value) = *value;
  }
  stated.scale_measurements = separated(given);
  if (is_batch) {
    BatchArguments batch = arguments.batch;
    batch.options = options_of_each(command);
    // A wrong name is one error, not one for each recording.
    batch.profile_sha256 = sha256_of(to_json(profile_of(stated)));
    return analyze_batch(batch);
  }
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() > 0 && option->get_group() == kBatchGroup) {
      throw UsageError(option->get_name() + ": for more than one recording; " + input + " is one");
    }
  }
  PipelineOptions pipeline = options_for(input, command, stated);
  for (ScaleMeasurement& one : pipeline.scale_measurements) one = with_modulus(one, profile_of(pipeline));
  const auto source = open_any_source(input, arguments.source, arguments.playback);
  const BatchResult result = measure_session(*source, pipeline, arguments.batch.job_count, arguments.batch.output,
                                             {.frames = !arguments.no_frames}, command_line());
  std::cout << summary(result, arguments.batch.output);
  require_measured(result, input);
}

void add_batch_options(CLI::App& command, BatchArguments& batch) {
  command.add_flag("--again", batch.again, "analyse also what is finished and unchanged")->group(kBatchGroup);
  command
      .add_option("--group-by", batch.group_by,
                  "compare groups: folder (that holds each recording), or a CSV table with the columns recording,group")
      ->group(kBatchGroup);
  command.add_flag("--list", batch.list, "print the recordings as CSV (name,input,state), and analyse nothing")
      ->group(kBatchGroup);
  command
      .add_option("--only", batch.only,
                  "analyse the recording of this name alone, without tables and page (may be given several times): for "
                  "several computers")
      ->allow_extra_args(false)
      ->group(kBatchGroup);
  command.add_flag("--collect", batch.collect, "write tables and page of what there is, and analyse nothing")
      ->group(kBatchGroup);
}

}  // namespace

void add_analyze_command(CLI::App& app) {
  auto arguments = std::make_shared<AnalyzeArguments>();
  CLI::App* command =
      app.add_subcommand("analyze", "measure recordings: contours, 3-D surface, forces, each into a session");
  command
      ->add_option(
          "input", arguments->batch.inputs,
          "video, folder of images, multi-page TIFF, still, session, or virtual[:SCENARIO]; or several of them, "
          "or a folder that holds such recordings")
      ->required();
  command
      ->add_option("--output", arguments->batch.output,
                   "folder of the session to write; of several recordings: for a session each, tables and a page")
      ->required();
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
      ->add_option(
          "--quality", arguments->quality,
          "live: as fast as the camera; high: the cell is found with level sets as well, and networks read each frame "
          "in full, for recordings where time does not matter")
      ->check(CLI::IsMember({"live", "high"}))
      ->capture_default_str();
  add_detection_option(*command, arguments->pipeline);
  ScaleMeasurement defaults;
  for (const FieldPlace& field : fields_of(defaults)) {
    if (field.key.starts_with("modulus") || field.key == "since_s") continue;
    std::string option = "--" + field.key;
    std::replace(option.begin(), option.end(), '_', '-');
    add_field_option(*command, option, field, arguments->scale[field.key], field.value_text())
        ->group("Scale of this cell");
  }
  add_range_options(*command, arguments->playback);
  command->add_flag("--no-frames", arguments->no_frames, "omit the images from the session");
  command
      ->add_option(
          "--jobs", arguments->batch.job_count,
          "1: one loop; more: the steps in parallel, with the same numbers; of several recordings: so many at once")
      ->capture_default_str();
  add_batch_options(*command, arguments->batch);
  command->callback([command, arguments] { analyze(*command, *arguments); });
}

}  // namespace pellucida
