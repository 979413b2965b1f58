#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "pellucida/core/Progress.h"
#include "pellucida/session/ConvertSession.h"

namespace pellucida {

void add_convert_command(CLI::App& app) {
  auto folders = std::make_shared<std::pair<std::string, std::string>>();
  CLI::App* command = app.add_subcommand("convert", "write a session once more, as small as this version writes");
  command->add_option("SESSION", folders->first, "folder of a session of any version; stays as it is")->required();
  command->add_option("--output", folders->second, "folder of the new session")->required();
  command->callback([folders] {
    ConvertReport report;
    {
      Progress progress("converting, steps");
      report = convert_session(folders->first, folders->second, [&](std::size_t done, std::size_t all) {
        progress.update(static_cast<long>(done), static_cast<long>(all));
      });
    }
    for (const std::string& note : report.notes) std::cerr << "pellucida: " << note << '\n';
    std::cout << report.after.step_count << " steps, " << report.before.byte_count / 1000 << " kB before, "
              << report.after.byte_count / 1000 << " kB now\nsession  " << folders->second << '\n';
  });
}

}  // namespace pellucida
