#pragma once
#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "pellucida/tracking/TrackerOptions.h"

namespace pellucida {

/// Adds `--detection lines|scene` to a command.
inline void add_detection_option(CLI::App& command, TrackerOptions::Detection& detection) {
  static const std::map<std::string, TrackerOptions::Detection> names{{"lines", TrackerOptions::Detection::kLines},
                                                                      {"scene", TrackerOptions::Detection::kScene}};
  command
      .add_option("--detection", detection,
                  "how cell and needle are found. lines: by dark lines, the most precise in bright field; scene: by a "
                  "network that knows relief and phase contrast as well")
      ->transform(CLI::CheckedTransformer(names))
      ->type_name("{lines,scene}")
      ->default_str("lines");
}

}  // namespace pellucida
