#include "pellucida/report/PassportReport.h"

#include <algorithm>
#include <array>

#include "PassportDoubts.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

struct ReportNames {
  fs::path folder, page, cells, contacts;
};

// Links followed; without a slash at its end.
fs::path true_place(const fs::path& folder) {
  const fs::path place = fs::weakly_canonical(fs::absolute(folder));
  return place.has_filename() ? place : place.parent_path();
}

// Whether `inner` is `outer` or lies in it.
bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path in = true_place(inner), out = true_place(outer);
  const auto [end_of_outer, rest] = std::mismatch(out.begin(), out.end(), in.begin(), in.end());
  return end_of_outer == out.end();
}

ReportNames names_of(const fs::path& session, const fs::path& output) {
  if (output.extension() == ".html") {
    const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
    const std::string stem = output.stem().string();
    return {folder, output, folder / (stem + "_cells.csv"), folder / (stem + "_contacts.csv")};
  }
  const fs::path folder = output.empty() ? session / kReportFolder : output;
  return {folder, folder / "report.html", folder / "cells.csv", folder / "contacts.csv"};
}

// The session stays as it is: nothing is put between its files, in their place, or where a link in it leads.
void require_outside(const fs::path& session, const ReportNames& names) {
  const fs::path own = session / kReportFolder;
  if (fs::is_symlink(fs::symlink_status(own)) && lies_in(names.folder, own)) {
    throw UsageError(own.string() + ": is a link, which is not followed; name another folder with --output");
  }
  if (lies_in(names.folder, session) && !lies_in(names.folder, own)) {
    throw UsageError("--output " + names.folder.string() +
                     ": lies in the session, whose files must stay as they are; "
                     "leave --output out for " +
                     own.string() + ", or name a folder outside");
  }
  for (const fs::path& file : {names.page, names.cells, names.contacts}) {
    for (const char* input : {"session.json", "session.pvd", "measurements.csv", "events.csv", "checksums.csv"}) {
      require_apart(file, session / input, "--output");
    }
  }
}

}  // namespace

std::vector<fs::path> report_names(const fs::path& session, const fs::path& output) {
  const ReportNames names = names_of(session, output);
  return {names.page, names.cells, names.contacts};
}

PassportReport write_report(const fs::path& session_folder, const fs::path& output, const SessionProgress& progress) {
  const SessionReader session(session_folder);
  const ReportNames names = names_of(session_folder, output);
  require_outside(session_folder, names);
  const PassportInput input = passport_input(session, progress);
  PassportReport report;
  report.cells = cell_passports(input);
  report.notes = session_doubts(session, input);

  make_folder(names.folder);
  const auto put = [&](const fs::path& file, const std::string& text) {
    replace_file(file, text);
    report.files.push_back(file);
  };
  put(names.cells, cells_csv(report.cells));
  put(names.contacts, contacts_csv(report.cells));
  put(names.page, passport_page(session, input, report.cells));
  return report;
}

}  // namespace pellucida
