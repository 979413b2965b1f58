#include "commands/ExportCommand.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "commands/Progress.h"
#include "pellucida/session/SessionExport.h"

namespace pellucida {
namespace {

struct ExportArguments {
  std::string session;
  std::string output;
  std::string frames = "peak";
};

void export_files(const ExportArguments& arguments) {
  ExportReport report;
  {
    Progress progress("exporting, contours");
    ExportOptions options{.frames = arguments.frames, .progress = {}};
    options.progress = [&](std::size_t done, std::size_t all) {
      progress.update(static_cast<long>(done), static_cast<long>(all));
    };
    report = export_session(arguments.session, arguments.output, options);
  }
  for (const auto& file : report.files) std::cout << file.string() << '\n';
  for (const std::string& note : report.notes) std::cerr << "pellucida: " << note << '\n';
}

}  // namespace

void add_export_command(CLI::App& app) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "write a session as flat CSV files for other tools");
  command->add_option("SESSION", arguments->session, "folder of the session")->required();
  command->add_option("--output", arguments->output, "folder for the files; made when it isn't there")->required();
  command
      ->add_option("--frames", arguments->frames,
                   "frames whose surface nodes go to nodes.csv: first, last, peak (largest force) or frame numbers, "
                   "comma separated")
      ->capture_default_str();
  command->callback([arguments] { export_files(*arguments); });
}

}  // namespace pellucida
