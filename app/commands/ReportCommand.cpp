#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "commands/ReplaceOption.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Progress.h"
#include "pellucida/report/PassportReport.h"

namespace pellucida {
namespace {

struct ReportArguments {
  std::string session;
  std::string output;
  bool replace = false;
};

// "cell 1: punctured; peak force 7.46 uN (6.71 to 8.32) at 43.9 um; 2 doubts"
void print_cell(const CellPassport& cell) {
  const ContactPassport& main = cell.main_contact();
  std::cout << "cell " << cell.cell << ": " << main.outcome;
  if (!std::isnan(main.peak_force_uN)) {
    char text[160];
    std::snprintf(text, sizeof text, "; peak force %.3g uN (%.3g to %.3g) at %.1f um", main.peak_force_uN,
                  main.peak_force_lower_uN, main.peak_force_upper_uN, main.peak_force_depth_um);
    std::cout << text;
  }
  const std::size_t doubt_count = cell.doubt_list.size() + main.doubt_list.size();
  if (doubt_count > 0) std::cout << "; " << doubt_count << (doubt_count == 1 ? " doubt" : " doubts");
  std::cout << '\n';
}

void report_session(const ReportArguments& arguments) {
  if (!arguments.replace) require_new(report_names(arguments.session, arguments.output));
  PassportReport report;
  {
    Progress progress("reading, surfaces");
    report = write_report(arguments.session, arguments.output, [&](std::size_t done, std::size_t all) {
      progress.update(static_cast<long>(done), static_cast<long>(all));
    });
  }
  for (const CellPassport& cell : report.cells) print_cell(cell);
  for (const auto& file : report.files) std::cout << file.string() << '\n';
  for (const std::string& note : report.notes) std::cerr << "pellucida: warning: " << note << '\n';
  if (report.cells.empty()) {
    throw NothingMeasuredError(arguments.session +
                               ": no cell was found in this session; the report says so. Check the recording with "
                               "pellucida workstation --source");
  }
}

}  // namespace

void add_report_command(CLI::App& app) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand(
      "report", "the dose passport of a session: a page to read and print, and tables with a row for each cell");
  command->add_option("SESSION", arguments->session, "folder of the session")->required();
  command->add_option("--output", arguments->output,
                      "folder for report.html, cells.csv and contacts.csv, or FILE.html for the page with the tables "
                      "beside it (default: SESSION/report)");
  add_replace_option(*command, arguments->replace);
  command->callback([arguments] { report_session(*arguments); });
}

}  // namespace pellucida
