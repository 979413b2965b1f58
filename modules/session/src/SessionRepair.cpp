#include "SessionRepair.h"

#include "Checksum.h"
#include "DiskFile.h"
#include "SessionFolder.h"
#include "pellucida/core/Error.h"
#include "pellucida/vtk_files/DataFile.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

std::string plural(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

// A free name in `damaged/`: what lies there already is kept.
fs::path free_name(const fs::path& folder, const fs::path& file) {
  make_folder(folder / session_name::kDamaged);
  fs::path target = folder / session_name::kDamaged / file.filename();
  for (int i = 1; is_present(target); ++i) {
    target = folder / session_name::kDamaged / (file.filename().string() + '.' + std::to_string(i));
  }
  return target;
}

// Of a link, the link itself.
void put_aside(const fs::path& folder, const std::string& name) {
  std::error_code reason;
  fs::rename(folder / name, free_name(folder, name), reason);
  if (reason) throw OutputError((folder / name).string() + ": can't be moved to damaged/ (" + reason.message() + ")");
}

// Writes a table anew from its whole rows; the others are kept in `damaged/lines.txt`, and all of it as it was beside.
template <class Row>
void mend_table(const fs::path& folder, const char* name, std::string_view header, const SessionTable<Row>& table,
                SessionReport& report) {
  if (table.present && table.header_right && table.bad.empty()) return;
  if (table.present) replace_file(free_name(folder, name), *table.text);
  if (!table.bad.empty()) {
    const fs::path kept = folder / session_name::kDamaged / session_name::kDamagedLines;
    std::string text = is_present(kept) ? read_whole_file(kept) : "";
    for (const BadLine& bad : table.bad)
      text += std::string(name) + ':' + std::to_string(bad.number) + ": " + std::string(bad.text) + '\n';
    replace_file(kept, text);
  }
  replace_file(folder / name, table_text(table, header));
  report.repairs.push_back(std::string(name) + ": rewritten with " + plural(table.rows.size(), "row", "rows") +
                           (table.bad.empty() ? "" : "; the others are in damaged/lines.txt"));
}

// A row for every data file: the one made when it was written, or one made now of a file that lost it.
void mend_checksums(const fs::path& folder, const SessionFindings& findings, const SessionFiles& files,
                    SessionReport& report) {
  if (!findings.checksums.present && !findings.measurements.checked) return;
  std::size_t new_count = 0;
  std::string text = std::string(session_name::kChecksumsHeader) + ',' + kRowChecksum + '\n';
  const auto add = [&](const DataName& name) {
    const FileChecksum* known = find_checksum(findings.checksums, name);
    FileChecksum one = known ? *known : FileChecksum{.name = name};
    if (!known) {
      const std::string content = read_whole_file(folder / data_file(name));
      one.byte_count = content.size();
      one.crc32 = crc32_of(content);
      ++new_count;
    }
    text += signed_row(to_csv(one)) + '\n';
  };
  for (const PartNames& names : kParts) {
    for (const long frame : files.frames[static_cast<std::size_t>(names.part)]) add(data_name(names.part, frame));
  }
  for (const long block : files.hand_blocks) add({kHandKind, block});
  const fs::path file = folder / session_name::kChecksums;
  if (findings.checksums.present && findings.checksums.bad.empty() && *findings.checksums.text == text) return;
  if (!findings.checksums.bad.empty())
    replace_file(free_name(folder, session_name::kChecksums), *findings.checksums.text);
  replace_file(file, text);
  report.repairs.push_back(std::string(session_name::kChecksums) + ": rebuilt" +
                           (new_count == 0 ? "" : ", " + plural(new_count, "checksum", "checksums") + " made anew"));
}

void mend_head(const fs::path& folder, const SessionFindings& findings, bool frames, SessionReport& report) {
  const fs::path file = folder / session_name::kJson;
  if (findings.head_readable) {
    const std::string text = repaired_json(file, report.counts);
    if (findings.head.changed) {
      replace_file(free_name(folder, session_name::kJson), read_whole_file(file));
      report.repairs.emplace_back(
          "session.json: was changed after it was written; its values stay as they are (check calibration and "
          "profile), "
          "as it was it is in damaged/");
    }
    replace_file(file, text);
    report.repairs.emplace_back("session.json: counts corrected");
    return;
  }
  if (is_present(file)) put_aside(folder, session_name::kJson);
  SessionHead head;
  head.options.frames = frames;
  head.info.software_version = "unknown";
  head.info.source.pixel_size_um = findings.pixel_size_um;
  head.info.source.pixel_size_origin = "frames";
  head.counts = report.counts;
  head.recovered = true;
  replace_file(file, to_json(head));
  report.repairs.emplace_back("session.json: rebuilt; source, profile and command line are lost");
}

}  // namespace

void repair_session(const fs::path& folder, const SessionFindings& findings, SessionReport& report) {
  // What can't be repaired without following it is left alone, all of it.
  if (!findings.files.links.empty()) {
    throw InputError((folder / findings.files.links.front()).string() +
                     ": a link, pipe or device, which a repair does not follow; put the file or folder itself there");
  }
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
  for (const std::string& name : findings.unreadable) put_aside(folder, name);
  if (!findings.unreadable.empty()) {
    report.repairs.push_back(plural(findings.unreadable.size(), "unreadable or wrongly stamped file",
                                    "unreadable or wrongly stamped files") +
                             " moved to damaged/");
  }

  mend_table(folder, session_name::kMeasurements, measurement_header(), findings.measurements, report);
  mend_table(folder, session_name::kEvents, session_name::kEventsHeader, findings.events, report);
  if (!in_order(findings.events)) sort_events(folder / session_name::kEvents);

  // Lists and counts anew from what is there now.
  if (!findings.empty_right && is_present(folder / session_name::kEmpty)) put_aside(folder, session_name::kEmpty);
  if (!is_present(folder / session_name::kEmpty)) {
    replace_file(folder / session_name::kEmpty, empty_poly_file());
  }
  const SessionFiles files = list_files(folder);
  mend_checksums(folder, findings, files, report);
  const std::vector<SessionStep> steps = make_steps(findings.measurements.rows, files);
  const bool frames = !files.frames[static_cast<std::size_t>(SessionPart::kFrame)].empty();
  replace_file(folder / session_name::kPvd, make_pvd(steps, frames));
  report.repairs.push_back("session.pvd rebuilt for " + plural(steps.size(), "step", "steps"));
  mend_head(folder, findings, frames, report);
  report.repaired = true;
}

}  // namespace pellucida
