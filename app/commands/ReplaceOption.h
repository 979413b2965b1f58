#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <vector>

#include "pellucida/core/Error.h"

namespace pellucida {

/// Adds `--replace` to a command: without it no file that is there is replaced. Recorded sessions know no such option.
inline void add_replace_option(CLI::App& command, bool& replace) {
  command.add_flag("--replace", replace, "replace files of these names that are there already");
}

/// Before any work is done: throws UsageError for the first of `files` that is there, unless `replace`. Empty names
/// and devices (`/dev/stdout`) are left out.
inline void require_new(const std::vector<std::filesystem::path>& files, bool replace) {
  if (replace) return;
  for (const auto& file : files) {
    std::error_code ignored;
    if (file.empty() || !std::filesystem::is_regular_file(file, ignored)) continue;
    throw UsageError(file.string() + ": already there; give another --output, or --replace to replace it");
  }
}

}  // namespace pellucida
