#include "commands/WorkstationRun.h"

#include <filesystem>
#include <iostream>
#include <optional>

#include "commands/CommandLine.h"
#include "commands/GuidedSession.h"
#include "commands/Interrupt.h"
#include "commands/MeasureSession.h"
#include "pellucida/charts_vtk/RenderPicture.h"
#include "pellucida/core/Error.h"
#include "pellucida/guide/Guide.h"
#include "pellucida/operation/OperatorConsole.h"
#include "pellucida/operation/VirtualExposure.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "pellucida/pipeline/AnySource.h"
#include "pellucida/pipeline/LiveRun.h"
#include "pellucida/review/Review.h"
#include "pellucida/start/Start.h"
#include "pellucida/teach/Teach.h"

namespace pellucida {
namespace {

void leave_picture(const WorkstationArguments& arguments, const std::string& session, const BatchResult& result) {
  const std::filesystem::path picture = arguments.window.screenshot.empty()
                                            ? std::filesystem::path(session) / "picture.png"
                                            : std::filesystem::path(arguments.window.screenshot);
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

// What a virtual microscope knows of its specimen; nothing of another source.
std::function<std::optional<double>(long)> truth_of(const FrameSource& source) {
  const auto* microscope = dynamic_cast<const VirtualMicroscope*>(&source);
  if (!microscope) return {};
  return [log = microscope->truth_log()](long frame) { return log->force_uN(frame); };
}

// With a hand: a virtual cell whose needle it moves. Without: any source.
int run_window(const WorkstationArguments& arguments, GuideOptions options) {
  const auto hand = hand_name(arguments);
  if (!hand) {
    auto source = open_any_source(arguments.source, arguments.source_options, arguments.playback);
    options.true_force_uN = truth_of(*source);
    if (is_virtual_source(arguments.source)) source = with_virtual_exposure(std::move(source));
    options.exposure = source->exposure();
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
  std::unique_ptr<FrameSource> microscope = setup.make_microscope(Pace::kWallClock);
  options.true_force_uN = truth_of(*microscope);
  microscope = with_virtual_exposure(std::move(microscope));
  options.exposure = microscope->exposure();
  auto run = std::make_unique<LiveRun>(std::move(microscope), arguments.pipeline);
  auto console = std::make_unique<OperatorConsole>(*run, setup.injector(), &setup.needle());
  options.hand = console->find_hand(*hand).value_or(-1);
  return run_guide(std::move(run), std::move(console), options);
}

// The window's options; the first signal closes it.
WindowOptions window_of(const WorkstationArguments& arguments) {
  WindowOptions window = arguments.window;
  window.stop_descriptor = interrupt_descriptor();
  return window;
}

// True when the person wants the start page next.
bool leads_to_page(int status) {
  if (status != 0 && status != kToStartPage) throw Error(ExitCode::kOurFault, "the window ended with an error");
  return status == kToStartPage;
}

bool run_teach_mode(const WorkstationArguments& arguments) {
  TeachOptions options;
  static_cast<WindowOptions&>(options) = window_of(arguments);
  options.lesson = arguments.lesson;
  options.large_letters = arguments.large_letters;
  return leads_to_page(run_teach(options));
}

// A recorded session in the window; nothing is measured.
bool run_review_mode(const WorkstationArguments& arguments) {
  if (!has_display()) {
    throw DeviceError(
        "--mode review needs a window: set DISPLAY to a running X server; without one, use pellucida "
        "report or pellucida export");
  }
  ReviewOptions options;
  static_cast<WindowOptions&>(options) = window_of(arguments);
  options.compare = arguments.compare;
  options.from_s = arguments.playback.from_s;
  options.speed_ratio = arguments.speed_ratio;
  options.loop = arguments.playback.loop_count != 1;
  options.backwards = arguments.playback.backwards;
  return leads_to_page(run_review(arguments.session, options));
}

bool run_guide_mode(const WorkstationArguments& arguments) {
  GuideOptions options;
  options.session_folder = arguments.session;
  static_cast<WindowOptions&>(options) = window_of(arguments);
  // A microscope does not end: the virtual one shows its scenario again and again.
  options.repeat = is_virtual_source(arguments.source);
  return leads_to_page(run_window(arguments, options));
}

// The arguments that the command line would have for a choice.
WorkstationArguments arguments_of(const StartChoice& choice, const WorkstationArguments& page) {
  WorkstationArguments arguments;
  arguments.window.theme = page.window.theme;
  arguments.window.language = page.window.language;
  arguments.mode = name_of(choice.mode);
  arguments.source = choice.source;
  if (!choice.profile.empty()) arguments.pipeline.profile = choice.profile;
  arguments.source_options.pixel_size_um = choice.pixel_size_um;
  arguments.source_options.frame_rate_hz = choice.frame_rate_hz;
  arguments.hand = choice.hand;
  arguments.session = choice.session;
  arguments.lesson = choice.lesson;
  arguments.large_letters = choice.large_letters;
  arguments.pipeline = options_for(
      arguments.source, [](const auto&) { return true; }, arguments.pipeline);
  return arguments;
}

// The session that a path names: its folder, or one of its files.
std::optional<std::filesystem::path> session_at(const std::filesystem::path& path) {
  if (path.empty()) return std::nullopt;
  if (is_session(path)) return path;
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  return is_session(folder) ? std::optional(folder) : std::nullopt;
}

}  // namespace

bool run_workstation(const WorkstationArguments& arguments) {
  // A window closes with the first signal, and its recording with it.
  const InterruptScope scope;
  if (arguments.mode == "teach") return run_teach_mode(arguments);
  if (arguments.mode == "review") return run_review_mode(arguments);
  if (has_display()) return run_guide_mode(arguments);
  run_headless(arguments);
  return false;
}

void run_start_mode(const WorkstationArguments& arguments) {
  if (!has_display()) {
    throw DeviceError(
        "--mode start needs a window: set DISPLAY to a running X server; without one, use pellucida workstation "
        "--source, or pellucida analyze");
  }
  const InterruptScope scope;
  StartOptions options;
  static_cast<WindowOptions&>(options) = window_of(arguments);
  if (const auto session = session_at(arguments.path)) {
    WorkstationArguments review = arguments;
    review.mode = "review";
    review.session = session->string();
    if (!run_workstation(review) || interrupted() != 0) return;
  } else {
    options.recording = arguments.path;
  }
  while (const auto choice = run_start(options)) {
    options.problem.clear();
    std::error_code ignored;
    options.recording = std::filesystem::exists(choice->source, ignored) ? choice->source : std::string();
    try {
      run_workstation(arguments_of(*choice, arguments));
    } catch (const Error& error) {
      // Back to the page, which says what went wrong.
      options.problem = error.what();
      // Nobody is there any more to read it on the page.
      if (interrupted() != 0) throw;
    }
    if (interrupted() != 0) break;
  }
}

}  // namespace pellucida
