#include "pellucida/session/SessionCheck.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "DiskFile.h"
#include "PartReader.h"
#include "PvdList.h"
#include "SessionFolder.h"
#include "SessionIndex.h"
#include "SessionJson.h"
#include "SessionLock.h"
#include "SessionRepair.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionClocks.h"
#include "pellucida/vtk_files/DataFile.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

// A ruined session of an hour must not fill the screen.
constexpr std::size_t kLinesKept = 50;
constexpr double kTimeTolerance_s = 1e-5;

// What a file says of itself goes to a terminal: without what moves the cursor there, and not without end.
std::string printable(std::string text) {
  constexpr std::size_t kMostBytes = 300;
  if (text.size() > kMostBytes) text = text.substr(0, kMostBytes) + "...";
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20U || c == 0x7FU; }, '?');
  return text;
}

// To a tenth, for a reader.
double rounded(double value) {
  return std::round(10.0 * value) / 10.0;
}

// A table; an empty one where there is none, or something else in its place.
template <class Read>
auto read_if_plain(const fs::path& file, Read read) {
  return is_plain_file(file) ? read(file) : decltype(read(file)){};
}

class Check {
 public:
  Check(const fs::path& folder, bool being_written, SessionReport& report, const SessionProgress& progress)
      : folder_(folder), being_written_(being_written), report_(report), progress_(progress) {}

  SessionFindings run() {
    found_.files = list_files(folder_);
    check_links();
    found_.checksums =
        read_if_plain(folder_ / session_name::kChecksums, [](const auto& file) { return read_checksums(file); });
    const bool checked = found_.checksums.present;
    found_.measurements = read_if_plain(folder_ / session_name::kMeasurements,
                                        [&](const auto& file) { return read_measurements(file, checked); });
    found_.events =
        read_if_plain(folder_ / session_name::kEvents, [&](const auto& file) { return read_events(file, checked); });
    check_head();
    check_table(session_name::kMeasurements, found_.measurements);
    check_table(session_name::kEvents, found_.events);
    check_checksums();
    check_files();
    if (!found_.files.temporary.empty()) {
      lag(std::to_string(found_.files.temporary.size()) + " unfinished temporary file(s), the first " +
          found_.files.temporary.front().lexically_relative(folder_).string());
    }
    check_pvd();
    check_empty();
    tell_clocks();
    count();
    return std::move(found_);
  }

 private:
  void problem(const std::string& text) {
    ++report_.problem_count;
    if (report_.problems.size() < kLinesKept) report_.problems.push_back(printable(text));
  }
  // What is damage only where nobody is still writing.
  void lag(const std::string& text) {
    if (!being_written_) problem(text);
  }

  void check_links() {
    for (const std::string& name : found_.files.links) {
      problem(name + ": a link, pipe or device, which is not followed; put the file or folder itself there");
    }
    for (const std::string& name : found_.files.strange) {
      problem(name + ": no file but a link, folder, pipe or device");
      found_.unreadable.push_back(name);
    }
  }

  // A head that is ours, or the files that only a session has: other folders have tables of these names, too, an export
  // for one.
  void require_session() const {
    if (found_.head_readable) return;
    const int tables = static_cast<int>(found_.measurements.header_right || found_.measurements.checked) +
                       static_cast<int>(found_.events.header_right || found_.events.checked);
    const int others = static_cast<int>(is_plain_file(folder_ / session_name::kPvd)) +
                       static_cast<int>(is_plain_file(folder_ / session_name::kEmpty)) +
                       static_cast<int>(found_.checksums.present) + static_cast<int>(found_.files.has_data());
    if (others >= 2 || (others >= 1 && tables >= 1)) return;
    throw InputError(
        folder_.string() +
        ": no session here (neither a readable session.json nor its other files); name a session's folder");
  }

  void check_head() {
    const fs::path file = folder_ / session_name::kJson;
    std::string fault = "session.json is missing";
    if (is_present(file)) {
      try {
        found_.head = read_session_json(file);
        found_.head_readable = true;
      } catch (const LaterSchemaError&) {
        throw;
      } catch (const InputError& error) {
        fault = without_path("session.json", file, error.what());
      }
    }
    require_session();
    if (!found_.head_readable) {
      problem(fault);
      return;
    }
    if (!found_.head.complete && !found_.head.recovered) lag("session.json: the recording was cut off");
    if (found_.head.changed) problem("session.json: was changed after it was written (its checksum is wrong)");
    if (!found_.head.checked && (found_.checksums.present || found_.measurements.checked)) {
      found_.head.changed = true;
      problem("session.json: was changed after it was written (its checksum is missing)");
    }
  }

  template <class Row>
  void check_table(const char* name, const SessionTable<Row>& table) {
    if (!table.present) {
      if (!is_present(folder_ / name)) problem(std::string(name) + " is missing");
      return;
    }
    if (!table.header_right) problem(std::string(name) + ":1: the header is not that of this table");
    for (const BadLine& bad : table.bad)
      problem(std::string(name) + ':' + std::to_string(bad.number) + ": " + bad.reason);
  }

  // Every data file has its checksum, and every checksum its file.
  void check_checksums() {
    const SessionTable<FileChecksum>& table = found_.checksums;
    if (!table.present) {
      if (found_.measurements.checked) {
        problem("checksums.csv is missing");
      } else {
        report_.notes.emplace_back("written without checksums: a number that was changed since is not noticed");
      }
      return;
    }
    check_table(session_name::kChecksums, table);
    std::size_t without = 0;
    const auto look_for = [&](const DataName& name) { without += find_checksum(table, name) ? 0U : 1U; };
    for (const PartNames& names : kParts) {
      for (const long frame : found_.files.frames[static_cast<std::size_t>(names.part)])
        look_for(data_name(names.part, frame));
    }
    for (const long block : found_.files.hand_blocks) look_for({kHandKind, block});
    if (without > 0) lag("checksums.csv: lacks " + std::to_string(without) + " data file(s)");

    const auto doubled = std::adjacent_find(table.rows.begin(), table.rows.end(),
                                            [](const auto& one, const auto& next) { return one.name == next.name; });
    if (doubled != table.rows.end()) problem("checksums.csv: more than one row for " + data_file(doubled->name));

    std::size_t missing = 0;
    std::string first;
    for (const FileChecksum& row : table.rows) {
      const auto& numbers = row.name.kind == kHandKind ? found_.files.hand_blocks
                                                       : found_.files.frames[static_cast<std::size_t>(row.name.kind)];
      if (std::binary_search(numbers.begin(), numbers.end(), row.name.number)) continue;
      if (++missing == 1) first = data_file(row.name);
    }
    if (missing > 0) {
      lag("checksums.csv: lists " + std::to_string(missing) + " file(s) that are not there, the first " + first);
    }
  }

  // Reads every data file and compares its stamp with its name and its row.
  void check_files() {
    const PartReader reader(folder_, found_.checksums, found_.head_readable ? found_.head.info.source : SourceInfo{});
    const std::vector<Measurement>& rows = found_.measurements.rows;
    std::size_t total = 0;
    for (const auto& frames : found_.files.frames) total += frames.size();
    total += found_.files.hand_blocks.size();

    std::size_t done = 0;
    std::size_t without_row = 0;
    for (const PartNames& names : kParts) {
      for (const long frame : found_.files.frames[static_cast<std::size_t>(names.part)]) {
        const auto row = std::lower_bound(rows.begin(), rows.end(), frame,
                                          [](const Measurement& one, long index) { return one.frame < index; });
        const bool has_row = row != rows.end() && row->frame == frame;
        without_row += has_row ? 0U : 1U;
        check_file(reader, data_name(names.part, frame), has_row ? &row->time_s : nullptr);
        if (progress_ && (++done % 64 == 0 || done == total)) progress_(done, total);
      }
    }
    for (const long block : found_.files.hand_blocks) {
      check_file(reader, {kHandKind, block}, nullptr);
      if (progress_ && (++done % 64 == 0 || done == total)) progress_(done, total);
    }
    if (without_row > 0 && !being_written_) {
      report_.notes.push_back(std::to_string(without_row) +
                              " data file(s) belong to no row of measurements.csv; they are kept, but listed nowhere");
    }
  }

  // Whatever a file holds, and whatever comes of reading it, is a problem of that file alone.
  void check_file(const PartReader& reader, const DataName& name, const double* time_s) {
    const std::string relative = data_file(name);
    const fs::path file = folder_ / relative;
    try {
      const vtkSmartPointer<vtkDataObject> data = read(reader, name);
      if (time_s && std::abs(stamped_time_s(data) - *time_s) > kTimeTolerance_s * std::max(1.0, std::abs(*time_s))) {
        throw InputError(file.string() + ": stamped " + csv_number(stamped_time_s(data)) + " s where its row says " +
                         csv_number(*time_s) + " s");
      }
    } catch (const std::exception& error) {
      problem(without_path(relative, file, error.what()));
      found_.unreadable.push_back(relative);
    }
  }

  // The text starts with the whole path: the session's own part of it is enough here.
  static std::string without_path(const std::string& name, const fs::path& file, const std::string& text) {
    return text.starts_with(file.string()) ? name + text.substr(file.string().size()) : name + ": " + text;
  }

  vtkSmartPointer<vtkDataObject> read(const PartReader& reader, const DataName& name) {
    if (name.kind != static_cast<int>(SessionPart::kFrame)) return reader.read_poly(name);
    const auto image = reader.read_image(name.number);
    if (found_.pixel_size_um == 0.0) found_.pixel_size_um = image->GetSpacing()[0];
    return image;
  }

  // The list must name exactly the files that the rows have, each at its row's time.
  void check_pvd() {
    const fs::path file = folder_ / session_name::kPvd;
    if (!is_plain_file(file)) {
      if (!is_present(file)) problem("session.pvd is missing");
      return;
    }
    const bool frames = found_.head_readable
                            ? found_.head.options.frames
                            : !found_.files.frames[static_cast<std::size_t>(SessionPart::kFrame)].empty();
    const PvdDifference pvd = compare_pvd(file, make_steps(found_.measurements.rows, found_.files), frames);
    found_.pvd_right = pvd.none();
    if (!pvd.readable) lag("session.pvd: not readable as the list of this session");
    if (pvd.missing_count > 0) {
      lag("session.pvd: does not list " + std::to_string(pvd.missing_count) + " file(s), the first " +
          pvd.first_missing);
    }
    if (pvd.extra_count > 0) {
      lag("session.pvd: lists " + std::to_string(pvd.extra_count) +
          " file(s) that are not there at that time, the first " + pvd.first_extra);
    }
  }

  // How well the times of camera and hand agree.
  void tell_clocks() {
    const auto clocks = found_.head_readable ? clock_fit_of(found_.head.info) : std::nullopt;
    if (!clocks) return;
    report_.notes.push_back("clocks: the source's drifts by " + csv_number(rounded(clocks->drift_ppm)) + " ppm (+- " +
                            csv_number(rounded(clocks->drift_sigma_ppm)) + ") against that of hand and injector; " +
                            csv_number(rounded(1e3 * clocks->scatter_s)) + " ms of scatter");
  }

  // The same content in every session; sessions of earlier versions may have it as VTK's own writer made it.
  void check_empty() {
    const fs::path file = folder_ / session_name::kEmpty;
    if (!is_plain_file(file)) {
      if (!is_present(file)) problem("empty.vtp is missing");
      return;
    }
    try {
      const std::string content = read_whole_file(file);
      found_.empty_right =
          content == empty_poly_file() || (!found_.checksums.present && poly_from(content)->GetNumberOfPoints() == 0);
    } catch (const InputError&) {
      found_.empty_right = false;
    }
    if (!found_.empty_right) problem("empty.vtp: is not the empty part that this version writes");
  }

  // What is really there: readable files that belong to a row.
  void count() {
    SessionCounts& counts = report_.counts;
    counts.step_count = found_.measurements.rows.size();
    counts.event_count = found_.events.rows.size();
    counts.unmeasured_count = static_cast<std::uint64_t>(std::count_if(
        found_.measurements.rows.begin(), found_.measurements.rows.end(), [](const auto& row) { return !row.state; }));
    for (const Event& event : found_.events.rows) count_left_out(event, counts);
    const std::set<std::string> unreadable(found_.unreadable.begin(), found_.unreadable.end());
    const auto add = [&](const DataName& name, std::uint64_t& file_count) {
      const std::string file = data_file(name);
      if (unreadable.contains(file)) return;
      ++file_count;
      std::error_code code;
      const std::uintmax_t bytes = fs::file_size(folder_ / file, code);
      if (!code) counts.byte_count += bytes;
    };
    for (const SessionStep& step : make_steps(found_.measurements.rows, found_.files)) {
      for (const PartNames& names : kParts) {
        if (step.has(names.part)) {
          add(data_name(names.part, step.frame_index), counts.file_count[static_cast<std::size_t>(names.part)]);
        }
      }
    }
    for (const long block : found_.files.hand_blocks) add({kHandKind, block}, counts.hand_block_count);
    // The rows count too, with their ends.
    counts.byte_count += table_bytes(found_.measurements, measurement_header());
    counts.byte_count += table_bytes(found_.events, session_name::kEventsHeader);
    compare_counts(counts);
  }

  // What the head says must be so; of a recording that was cut off it says what was a second before.
  void compare_counts(const SessionCounts& counts) {
    if (!found_.head_readable || !(found_.head.complete || found_.head.recovered)) return;
    const SessionCounts& stated = found_.head.counts;
    const auto compare = [&](const std::string& what, std::uint64_t said, std::uint64_t is, const char* where = "") {
      if (said != is) {
        problem("session.json: says " + std::to_string(said) + ' ' + what + ", there are " + std::to_string(is) +
                where);
      }
    };
    compare("steps", stated.step_count, counts.step_count, " in measurements.csv");
    compare("events", stated.event_count, counts.event_count, " in events.csv");
    compare("files of the hand", stated.hand_block_count, counts.hand_block_count);
    for (const PartNames& names : kParts) {
      compare(std::string(names.folder) + " files", stated.files(names.part), counts.files(names.part));
    }
  }

  const fs::path folder_;
  const bool being_written_;
  SessionReport& report_;
  const SessionProgress& progress_;
  SessionFindings found_;
};

}  // namespace

SessionReport check_session(const fs::path& folder, bool repair, const SessionProgress& progress) {
  std::error_code status;
  if (!fs::is_directory(folder, status)) throw InputError(folder.string() + ": no such session folder; check the path");
  // Held until the repair is done: nobody records into what is being repaired.
  const SessionLock lock(folder);
  if (lock.refused() && repair) {
    throw InputError(folder.string() +
                     ": a program is recording into this session, or repairing it; repair it when that has ended");
  }
  SessionReport report;
  if (lock.refused()) {
    report.notes.emplace_back("a program is recording into this session: what it has not finished yet is no damage");
  }
  const SessionFindings findings = Check(folder, lock.refused(), report, progress).run();
  if (repair && report.problem_count > 0) repair_session(folder, findings, report);
  return report;
}

}  // namespace pellucida
