#include "SessionRepair.h"

#include "DataFile.h"
#include "DiskFile.h"
#include "SessionFolder.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

std::string plural(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

// A free name in `damaged/`: what lies there already is kept.
fs::path put_aside(const fs::path& folder, const fs::path& file) {
  make_folder(folder / session_name::kDamaged);
  fs::path target = folder / session_name::kDamaged / file.filename();
  for (int i = 1; fs::exists(target); ++i) {
    target = folder / session_name::kDamaged / (file.filename().string() + '.' + std::to_string(i));
  }
  std::error_code reason;
  fs::rename(file, target, reason);
  if (reason) throw OutputError(file.string() + ": can't be moved to damaged/ (" + reason.message() + ")");
  return target;
}

// Writes a table anew from its whole lines; the others are kept in `damaged/lines.txt`.
template <class Row>
void mend_table(const fs::path& folder, const char* name, std::string_view header, const SessionTable<Row>& table,
                SessionReport& report) {
  if (table.present && table.header_right && table.bad.empty()) return;
  if (!table.bad.empty()) {
    make_folder(folder / session_name::kDamaged);
    const fs::path kept = folder / session_name::kDamaged / "lines.txt";
    std::string text = fs::exists(kept) ? read_whole_file(kept) : "";
    for (const BadLine& bad : table.bad)
      text += std::string(name) + ':' + std::to_string(bad.number) + ": " + bad.text + '\n';
    replace_file(kept, text);
  }
  std::string text = std::string(header) + '\n';
  for (const std::string& line : table.lines) text += line + '\n';
  replace_file(folder / name, text);
  report.repairs.push_back(std::string(name) + ": rewritten with " + plural(table.rows.size(), "row", "rows") +
                           (table.bad.empty() ? "" : "; the others are in damaged/lines.txt"));
}

}  // namespace

void repair_session(const fs::path& folder, const SessionFindings& findings, SessionReport& report) {
  // Away with what was never finished and what can't be read.
  for (const fs::path& file : findings.files.temporary) {
    std::error_code reason;
    fs::remove(file, reason);
    if (reason) throw OutputError(file.string() + ": can't be removed (" + reason.message() + ")");
  }
  if (!findings.files.temporary.empty()) {
    report.repairs.push_back(
        plural(findings.files.temporary.size(), "unfinished temporary file", "unfinished temporary files") +
        " removed");
  }
  for (const fs::path& file : findings.unreadable) put_aside(folder, file);
  if (!findings.unreadable.empty()) {
    report.repairs.push_back(plural(findings.unreadable.size(), "unreadable or wrongly stamped file",
                                    "unreadable or wrongly stamped files") +
                             " moved to damaged/");
  }

  mend_table(folder, session_name::kMeasurements, measurement_header(), findings.measurements, report);
  mend_table(folder, session_name::kEvents, session_name::kEventsHeader, findings.events, report);
  sort_events(folder / session_name::kEvents);

  // Lists and counts anew from what is there now.
  if (!fs::exists(folder / session_name::kEmpty)) {
    replace_file(folder / session_name::kEmpty, empty_poly_file());
  }
  const SessionFiles files = list_files(folder);
  const std::vector<SessionStep> steps = make_steps(findings.measurements.rows, files);
  const bool frames = !files.frames[static_cast<std::size_t>(SessionPart::kFrame)].empty();
  replace_file(folder / session_name::kPvd, make_pvd(steps, frames));
  report.repairs.push_back("session.pvd rebuilt for " + plural(steps.size(), "step", "steps"));

  SessionHead head = findings.head;
  if (!findings.head_readable) {
    if (fs::exists(folder / session_name::kJson)) put_aside(folder, folder / session_name::kJson);
    head.options.frames = frames;
    head.info.software_version = "unknown";
    head.info.source.pixel_size_um = findings.pixel_size_um;
    head.info.source.pixel_size_origin = "frames";
  }
  head.counts = report.counts;
  head.recovered = true;
  replace_file(folder / session_name::kJson, to_json(head));
  report.repairs.push_back(findings.head_readable ? "session.json: counts corrected"
                                                  : "session.json: rebuilt; source, profile and command line are lost");
  report.repaired = true;
}

}  // namespace pellucida
