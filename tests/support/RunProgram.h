#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "support/Files.h"

namespace pellucida::test {

/// What a command left behind.
struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs `pellucida ARGUMENTS` (PELLUCIDA_PROGRAM, set by the build) through the shell, without a display unless the
/// arguments bring one. `folder` takes its two output files.
inline Outcome run_program(const std::string& arguments, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const auto out = folder / "stdout.txt";
  const auto err = folder / "stderr.txt";
  const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY '" PELLUCIDA_PROGRAM "' " + arguments + " >'" +
                              out.string() + "' 2>'" + err.string() + "' </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

/// A fresh, empty folder of this name below the test's temporary folder.
inline std::filesystem::path fresh_folder(const std::string& name, const std::string& temporary) {
  const auto folder = std::filesystem::path(temporary) / ("pellucida_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace pellucida::test
