#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>

#include "commands/FieldOption.h"
#include "commands/Interrupt.h"
#include "commands/ReplaceOption.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Progress.h"
#include "pellucida/simulation/FrameWriter.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida {
namespace {

struct SimulateArguments {
  std::string scenario = "default";
  std::string output;
  std::string truth;
  std::string look;
  std::optional<double> duration_s;
  std::optional<double> frame_rate_hz;
  std::optional<std::uint64_t> seed;
  bool replace = false;
};

void simulate(const SimulateArguments& arguments) {
  Scenario scenario = load_scenario(arguments.scenario);
  if (arguments.duration_s) {
    // 0 means "the motion's length" in a scenario; here it can only be a mistake.
    if (!(*arguments.duration_s > 0)) throw UsageError("--duration-s must be above 0, up to 3600");
    scenario.image.duration_s = *arguments.duration_s;
  }
  if (arguments.frame_rate_hz) scenario.image.frame_rate_hz = *arguments.frame_rate_hz;
  if (arguments.seed) scenario.seed = *arguments.seed;
  if (!arguments.look.empty()) scenario.look = arguments.look;

  require_apart(arguments.output, arguments.scenario, "--output");
  require_apart(arguments.truth, arguments.scenario, "--truth");
  require_apart(arguments.truth, arguments.output, "--truth");
  if (!arguments.replace) require_new({arguments.output, arguments.truth});
  VirtualMicroscope microscope(scenario);
  // The small file first: where it can't be written, the video of an earlier run is left alone.
  std::optional<TruthWriter> truth;
  if (!arguments.truth.empty()) truth.emplace(arguments.truth);
  const auto writer = FrameWriter::open(arguments.output, microscope.info());

  long count = 0;
  const InterruptScope interrupt;
  InterruptibleSource source(microscope);
  {
    Progress progress("frame");
    while (const auto frame = source.next()) {
      writer->write(*frame);
      if (truth) truth->write(microscope.truth());
      progress.update(++count, microscope.info().frame_count);
    }
  }
  writer->close();
  std::cout << arguments.output << ": " << count << " frames, " << microscope.info().width_px << " x "
            << microscope.info().height_px << " px, " << microscope.info().pixel_size_um << " um/px, "
            << microscope.info().frame_rate_hz << " frames/s; " << writer->format() << '\n';
  if (truth)
    std::cout << arguments.truth << ": truth; contours in " << TruthWriter::contour_file(arguments.truth).string()
              << '\n';
}

// A list for the help, which must work without the resources.
std::string known_names(std::vector<std::string> (*names)()) {
  std::string known;
  try {
    for (const auto& name : names()) known += (known.empty() ? "" : ", ") + name;
  } catch (const Error&) {
    known = "none found";
  }
  return known;
}

}  // namespace

void add_simulate_command(CLI::App& app) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command = app.add_subcommand("simulate", "render a virtual injection with known truth");
  command->add_option("--scenario", arguments->scenario, "a JSON file or one of: " + known_names(scenario_names))
      ->capture_default_str();
  command->add_option("--look", arguments->look,
                      "contrast, tools and camera: " + std::string(kDrawing) +
                          ", a JSON file or one of: " + known_names(look_names) + " (default: the scenario's)");
  command
      ->add_option("--output", arguments->output,
                   ".avi or .mkv (lossless), .mp4 (lossy), .tif (pages), or no extension: a folder of PNG")
      ->required();
  command->add_option("--truth", arguments->truth,
                      "CSV of the truth, one row per frame; contours in a second file beside it (um, uN, Pa)");
  Scenario defaults;
  const FieldList fields = fields_of(defaults);
  add_field_option(*command, "--duration-s", *fields.find("image.duration_s"), arguments->duration_s, "the scenario's");
  add_field_option(*command, "--fps", *fields.find("image.frame_rate_hz"), arguments->frame_rate_hz, "the scenario's");
  command->add_option("--seed", arguments->seed, "of noise, grain and debris (default: the scenario's)")
      ->check(number_in({0.0, kMostSeed}));
  add_replace_option(*command, arguments->replace);
  command->callback([arguments] { simulate(*arguments); });
}

}  // namespace pellucida
