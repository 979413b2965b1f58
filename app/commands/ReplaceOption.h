#pragma once
#include <CLI/CLI.hpp>

#include "pellucida/core/NewFiles.h"

namespace pellucida {

/// Adds `--replace` to a command: without it no file that is there is replaced. Recorded sessions know no such option.
inline void add_replace_option(CLI::App& command, bool& replace) {
  command.add_flag("--replace", replace, "replace files of these names that are there already");
}

}  // namespace pellucida
