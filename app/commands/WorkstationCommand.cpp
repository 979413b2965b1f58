#include "commands/WorkstationCommand.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <optional>

#include "commands/CommandLine.h"
#include "commands/DetectionOption.h"
#include "commands/FieldOption.h"
#include "commands/GuidedSession.h"
#include "commands/MeasureSession.h"
#include "commands/PlaybackOption.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/operation/OperatorConsole.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "pellucida/pipeline/AnySource.h"
#include "pellucida/pipeline/LiveRun.h"
#include "pellucida/review/Review.h"
#include "pellucida/teach/Teach.h"
#include "pellucida/ui/Guide.h"
#include "pellucida/visualization_vtk/RenderPicture.h"

namespace pellucida {
namespace {

struct WorkstationArguments {
  std::string source = "virtual";
  PipelineOptions pipeline;
  SourceOptions source_options;
  PlaybackOptions playback;
  double speed_ratio = 1.0;
  std::string mode = "guide";
  std::string lesson;
  std::string theme = "dark";
  bool large_letters = false;
  std::string hand;
  std::string session;
  std::string screenshot;
  double after_s = 8.0;
  int width_px = 1400;
  int height_px = 900;
};

void leave_picture(const WorkstationArguments& arguments, const std::string& session, const BatchResult& result) {
  const std::filesystem::path picture = arguments.screenshot.empty() ? std::filesystem::path(session) / "picture.png"
                                                                     : std::filesystem::path(arguments.screenshot);
  render_picture(*result.peak, result.rows, picture);
  std::cout << "picture  " << picture.string() << '\n';
}

// No display and nothing named: a guided injection by the simulated operator on the virtual microscope.
void run_headless_injection(const WorkstationArguments& arguments, const std::string& session) {
  const SimulatedInjectionOptions operated;
  const GuidedResult result = measure_guided_session(operated, arguments.pipeline, session, {}, command_line());
  std::cout << summary(result.measured, session) << summary(result.injection);
  require_measured(result.measured, "virtual:" + operated.scenario);
  leave_picture(arguments, session, result.measured);
}

// No display: the same run, every frame measured, a session and a picture left behind.
void run_headless(const WorkstationArguments& arguments) {
  const std::string session = arguments.session.empty() ? default_session_folder() : arguments.session;
  std::cerr << "pellucida: no display (DISPLAY is not set): running headless\n";
  if (arguments.hand == "mouse") throw UsageError("--hand mouse needs the window: set DISPLAY, or choose another hand");
  if (arguments.source == "virtual" && arguments.hand != "none") {
    run_headless_injection(arguments, session);
    return;
  }
  const auto source = open_any_source(arguments.source, arguments.source_options, arguments.playback);
  if (arguments.playback.loop_count == 0) {
    throw UsageError("--loop 0 never ends and needs the window; set DISPLAY, or give a number");
  }
  if (source->info().live) {
    throw UsageError(arguments.source + ": a live camera never ends and needs the window; set DISPLAY, or name a " +
                     "recording or a virtual microscope");
  }
  const BatchResult result = measure_session(*source, arguments.pipeline, 2, session, {}, command_line());
  std::cout << summary(result, session);
  require_measured(result, arguments.source);
  leave_picture(arguments, session, result);
}

// The name that the hand's console has for a name on the command line; nothing for no hand.
std::optional<std::string_view> hand_name(const WorkstationArguments& arguments) {
  const std::string& hand = arguments.hand;
  if (hand.empty()) return is_virtual_source(arguments.source) ? std::optional("Demonstration") : std::nullopt;
  if (hand == "demonstration") return "Demonstration";
  if (hand == "mouse") return "Mouse";
  return std::nullopt;
}

// With a hand: a virtual cell whose needle it moves. Without: any source.
int run_window(const WorkstationArguments& arguments, GuideOptions options) {
  const auto hand = hand_name(arguments);
  if (!hand) {
    auto source = open_any_source(arguments.source, arguments.source_options, arguments.playback);
    return run_guide(std::make_unique<LiveRun>(std::move(source), arguments.pipeline, arguments.speed_ratio), nullptr,
                     options);
  }
  if (!is_virtual_source(arguments.source)) {
    throw UsageError("--hand " + arguments.hand + ": " + arguments.source +
                     " has no pipette that a hand could move; use --source virtual, or --hand none");
  }
  if (arguments.source_options.pixel_size_um || arguments.source_options.frame_rate_hz) {
    throw UsageError(arguments.source +
                     ": the scenario fixes pixel size and frame rate; leave out --pixel-size-um and --fps");
  }
  const auto colon = arguments.source.find(':');
  VirtualInjectionSetup setup(colon == std::string::npos ? "injection" : arguments.source.substr(colon + 1));
  auto run = std::make_unique<LiveRun>(setup.make_microscope(Pace::kWallClock), arguments.pipeline);
  auto console = std::make_unique<OperatorConsole>(*run, setup.injector(), &setup.needle());
  options.hand = console->find_hand(*hand).value_or(-1);
  return run_guide(std::move(run), std::move(console), options);
}

void set_window(const WorkstationArguments& arguments, WindowOptions& options) {
  options.screenshot = arguments.screenshot;
  options.screenshot_after_s = arguments.after_s;
  options.width_px = arguments.width_px;
  options.height_px = arguments.height_px;
}

void require_closed_well(int status) {
  if (status != 0) throw Error(ExitCode::kOurFault, "the window ended with an error");
}

void run_teach_mode(const WorkstationArguments& arguments) {
  TeachOptions options;
  set_window(arguments, options);
  options.lesson = arguments.lesson;
  options.light_theme = arguments.theme == "light";
  options.large_letters = arguments.large_letters;
  require_closed_well(run_teach(options));
}

// A recorded session in the window; nothing is measured.
void run_review_mode(const WorkstationArguments& arguments) {
  if (!has_display()) {
    throw DeviceError(
        "--mode review needs a window: set DISPLAY to a running X server; without one, use pellucida "
        "report or pellucida export");
  }
  ReviewOptions options;
  set_window(arguments, options);
  options.from_s = arguments.playback.from_s;
  options.speed_ratio = arguments.speed_ratio;
  options.loop = arguments.playback.loop_count != 1;
  options.backwards = arguments.playback.backwards;
  require_closed_well(run_review(arguments.session, options));
}

void run_workstation_command(const WorkstationArguments& arguments) {
  if (arguments.mode == "teach") {
    run_teach_mode(arguments);
    return;
  }
  if (!has_display()) {
    run_headless(arguments);
    return;
  }
  GuideOptions options;
  options.session_folder = arguments.session;
  set_window(arguments, options);
  // A microscope does not end: the virtual one shows its scenario again and again.
  options.repeat = is_virtual_source(arguments.source);
  require_closed_well(run_window(arguments, options));
}

}  // namespace

void add_workstation_command(CLI::App& app) {
  auto arguments = std::make_shared<WorkstationArguments>();
  CLI::App* command =
      app.add_subcommand("workstation", "the window: live feed, 3-D membrane, forces (the default command)");
  command->add_option("--source", arguments->source, "virtual[:SCENARIO], a file, a session, or a camera v4l2:N")
      ->capture_default_str();
  command->add_option("--profile", arguments->pipeline.profile, "cell profile, by name or file")->capture_default_str();
  add_detection_option(*command, arguments->pipeline.tracker.detection);
  command->add_option("--pixel-size-um", arguments->source_options.pixel_size_um,
                      "edge of a pixel, um (default: metadata)");
  command->add_option("--fps", arguments->source_options.frame_rate_hz, "frames a second (default: metadata)");
  command->add_option("--max-megapixels", arguments->source_options.most_megapixels, "refuse larger images, megapixels")
      ->capture_default_str();
  add_range_options(*command, arguments->playback);
  add_showing_options(*command, arguments->playback, arguments->speed_ratio);
  command
      ->add_option("--mode", arguments->mode,
                   "guide: a source live, with its forces; review: a recorded session, as it was recorded; teach: a "
                   "simulated cell and lessons")
      ->check(CLI::IsMember({"guide", "review", "teach"}))
      ->capture_default_str();
  command->add_option("--lesson", arguments->lesson,
                      "of Teach mode to begin with, by name or file (default: the first)");
  command->add_option("--theme", arguments->theme, "of Teach mode: dark, or light for projectors")
      ->check(CLI::IsMember({"dark", "light"}))
      ->capture_default_str();
  command->add_flag("--large-letters", arguments->large_letters, "Teach mode in larger letters");
  command
      ->add_option("--hand", arguments->hand,
                   "what moves the needle of a virtual source: demonstration (its default), mouse, or none (the "
                   "scenario's own motion)")
      ->check(CLI::IsMember({"demonstration", "mouse", "none"}));
  command->add_option(
      "--session", arguments->session,
      "guide: folder to record into (default: a new one in ~/Pellucida); review: folder of the session to open "
      "(default: the window asks)");
  command->add_option("--screenshot", arguments->screenshot, "save the window as a PNG file, then close");
  command->add_option("--after", arguments->after_s, "seconds before the screenshot")
      ->check(number_in({0.0, 86400.0}))
      ->capture_default_str();
  command->add_option("--width-px", arguments->width_px, "width of the window at the start, px")
      ->check(CLI::Range(800, 8000))
      ->capture_default_str();
  command->add_option("--height-px", arguments->height_px, "height of the window at the start, px")
      ->check(CLI::Range(500, 8000))
      ->capture_default_str();
  command->callback([command, arguments] {
    if (arguments->mode != "teach" &&
        (!arguments->lesson.empty() || arguments->theme != "dark" || arguments->large_letters)) {
      throw UsageError("--lesson, --theme and --large-letters belong to --mode teach; add it, or leave them out");
    }
    if (arguments->mode == "review") {
      for (const char* option : {"--source", "--profile", "--hand", "--pixel-size-um", "--fps", "--to", "--every"}) {
        if (command->count(option) == 0) continue;
        throw UsageError(std::string(option) +
                         " has no meaning with --mode review, which shows a session as it was "
                         "recorded; leave it out, or use --mode guide");
      }
      run_review_mode(*arguments);
      return;
    }
    arguments->pipeline = options_for(arguments->source, *command, arguments->pipeline);
    run_workstation_command(*arguments);
  });
}

}  // namespace pellucida
