#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "pellucida/tracking/TrackerOptions.h"

namespace pellucida {

/// Adds `--detection lines|scene` to a command.
inline void add_detection_option(CLI::App& command, TrackerOptions::Detection& detection) {
  command
      .add_option_function<std::string>(
          "--detection",
          [&detection](const std::string& name) {
            detection = name == "scene" ? TrackerOptions::Detection::kScene : TrackerOptions::Detection::kLines;
          },
          "how cell and needle are found. lines: by dark lines, the most precise in bright field; scene: by a network "
          "that knows relief and phase contrast as well, ten times slower and validated on drawn films alone")
      ->check(CLI::IsMember({"lines", "scene"}))
      ->default_str("lines");
}

}  // namespace pellucida
