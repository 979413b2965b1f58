#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "pellucida/pipeline/PipelineOptions.h"

namespace pellucida {

/// Adds `--detection auto|lines|scene` and a person's hints to a command.
inline void add_detection_option(CLI::App& command, PipelineOptions& pipeline) {
  for (const HintOption& option : hint_options()) {
    const auto add = [&, option](const std::vector<std::string>& texts) { add_hints(pipeline.hints, option, texts); };
    command.add_option_function<std::vector<std::string>>(option.name, add, option.meaning)->allow_extra_args(false);
  }
  command
      .add_option_function<std::string>(
          "--detection",
          [&pipeline](const std::string& name) { pipeline.tracker.detection = *detection_from_string(name); },
          "how cell and needle are found. lines: by dark lines, the most precise where membranes are such; scene: by a "
          "network that knows relief and phase contrast as well, two to three times slower; auto: by lines where the "
          "network "
          "sees the same, else by the network")
      ->check(CLI::IsMember({"auto", "lines", "scene"}))
      ->default_str("auto");
}

}  // namespace pellucida
