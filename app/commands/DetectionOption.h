#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "pellucida/tracking/TrackerOptions.h"

namespace pellucida {

/// Adds `--detection auto|lines|scene` to a command.
inline void add_detection_option(CLI::App& command, TrackerOptions::Detection& detection) {
  command
      .add_option_function<std::string>(
          "--detection", [&detection](const std::string& name) { detection = *detection_from_string(name); },
          "how cell and needle are found. lines: by dark lines, the most precise where membranes are such; scene: by a "
          "network that knows relief and phase contrast as well, ten times slower; auto: by lines where the network "
          "sees the same, else by the network")
      ->check(CLI::IsMember({"auto", "lines", "scene"}))
      ->default_str("auto");
}

}  // namespace pellucida
