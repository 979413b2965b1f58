#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "commands/DetectionOption.h"
#include "commands/FieldOption.h"
#include "commands/PlaybackOption.h"
#include "commands/ReplaceOption.h"
#include "commands/WorkstationRun.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/core/NewFiles.h"

namespace pellucida {
namespace {

void refuse_options(const CLI::App& command, std::initializer_list<const char*> options, const std::string& reason) {
  for (const char* option : options) {
    if (command.count(option) == 0) continue;
    throw UsageError(std::string(option) + " has no meaning with " + reason + "; leave it out, or use --mode guide");
  }
}

}  // namespace

void add_workstation_command(CLI::App& app) {
  auto arguments = std::make_shared<WorkstationArguments>();
  CLI::App* command =
      app.add_subcommand("workstation", "the window: live feed, 3-D membrane, forces (the default command)");
  command->add_option("path", arguments->path, "a session, or a recording, to open; without --mode, or with start");
  command->add_option("--source", arguments->source, "virtual[:SCENARIO], a file, a session, or a camera v4l2:N")
      ->capture_default_str();
  command->add_option("--profile", arguments->pipeline.profile, "cell profile, by name or file")->capture_default_str();
  add_detection_option(*command, arguments->pipeline);
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
                   "simulated cell and lessons; start: a page that offers all of them")
      ->check(CLI::IsMember({"guide", "review", "teach", "start"}))
      ->capture_default_str();
  command->add_option("--lesson", arguments->lesson,
                      "of Teach mode to begin with, by name or file (default: the first)");
  command->add_option("--theme", arguments->window.theme, "dark, or light for bright rooms (default: chosen last)")
      ->check(CLI::IsMember({"dark", "light"}));
  command->add_option("--language", arguments->window.language, "en or de (default: chosen last, else the system's)")
      ->check(CLI::IsMember({"en", "de"}));
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
  command->add_option("--compare", arguments->compare, "review: folder of a session to compare with");
  command->add_option("--screenshot", arguments->window.screenshot, "save the window as a PNG file, then close");
  command->add_option("--after", arguments->window.screenshot_after_s, "seconds before the screenshot or the figures")
      ->check(number_in({0.0, 86400.0}))
      ->capture_default_str();
  command->add_option("--figures", arguments->window.figures,
                      "guide: write frames/s, blocks, start time and memory of the window as JSON, then close");
  add_replace_option(*command, arguments->replace);
  command->add_option("--width-px", arguments->window.width_px, "width of the window at the start, px")
      ->check(CLI::Range(800, 8000))
      ->capture_default_str();
  command->add_option("--height-px", arguments->window.height_px, "height of the window at the start, px")
      ->check(CLI::Range(500, 8000))
      ->capture_default_str();
  command->callback([command, arguments] {
    const auto belongs = [&](const char* option, const char* mode) {
      if (command->count(option) > 0 && arguments->mode != mode)
        throw UsageError(std::string(option) + " belongs to --mode " + mode + "; add it, or leave it out");
    };
    for (const char* option : {"--lesson", "--large-letters"}) belongs(option, "teach");
    belongs("--compare", "review");
    belongs("--figures", "guide");
    for (const std::string& file : {arguments->window.screenshot, arguments->window.figures}) {
      if (!file.empty() && !arguments->replace) require_new({file});
    }
    arguments->window.remembered_size = command->count("--width-px") + command->count("--height-px") == 0;
    if (command->count("path") > 0) {
      if (command->count("--mode") > 0 && arguments->mode != "start") {
        throw UsageError(arguments->path + ": --mode " + arguments->mode + " takes no path of its own; name it by " +
                         (arguments->mode == "guide" ? "--source" : "--session"));
      }
      arguments->mode = "start";
    }
    if (arguments->mode == "start") {
      refuse_options(*command,
                     {"--source", "--profile", "--detection", "--hand", "--pixel-size-um", "--fps", "--max-megapixels",
                      "--session", "--from", "--to", "--every", "--speed", "--loop", "--backwards"},
                     "--mode start, whose page asks for it");
      run_start_mode(*arguments);
      return;
    }
    if (arguments->mode == "review") {
      refuse_options(*command, {"--source", "--profile", "--hand", "--pixel-size-um", "--fps", "--to", "--every"},
                     "--mode review, which shows a session as it was recorded");
    } else if (arguments->mode == "guide") {
      arguments->pipeline = options_for(arguments->source, *command, arguments->pipeline);
    }
    if (run_workstation(*arguments)) run_start_mode(*arguments);
  });
}

}  // namespace pellucida
