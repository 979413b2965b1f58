#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "commands/ReplaceOption.h"
#include "pellucida/charts_vtk/RenderPicture.h"
#include "pellucida/core/Progress.h"
#include "pellucida/session/SessionExport.h"

namespace pellucida {
namespace {

struct ExportArguments {
  std::string session;
  std::string output;
  std::string frames = "peak";
  bool no_picture = false;
  bool replace = false;
};

// One picture of the whole session: the scene at the largest force, above the curves of all rows.
void export_picture(const ExportArguments& arguments) {
  const SessionReader session(arguments.session);
  if (session.measurements().empty()) return;
  const auto picture = std::filesystem::path(arguments.output) / "session.png";
  render_picture(session.load(telling_step(session)), session.measurements(), picture);
  std::cout << picture.string() << '\n';
}

void export_files(const ExportArguments& arguments) {
  std::vector<std::filesystem::path> files = export_names(arguments.output);
  if (!arguments.no_picture) files.push_back(std::filesystem::path(arguments.output) / "session.png");
  if (!arguments.replace) require_new(files);
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
  if (!arguments.no_picture) export_picture(arguments);
}

}  // namespace

void add_export_command(CLI::App& app) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "write a session as flat CSV files and a picture, for other tools");
  command->add_option("SESSION", arguments->session, "folder of the session")->required();
  command->add_option("--output", arguments->output, "folder for the files; created if missing")->required();
  command
      ->add_option("--frames", arguments->frames,
                   "frames whose surface nodes go to nodes.csv: first, last, peak (largest force) or frame numbers, "
                   "comma separated")
      ->capture_default_str();
  command->add_flag("--no-picture", arguments->no_picture, "omit session.png, which needs an X server or Xvfb");
  add_replace_option(*command, arguments->replace);
  command->callback([arguments] { export_files(*arguments); });
}

}  // namespace pellucida
