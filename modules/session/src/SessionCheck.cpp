#include "pellucida/session/SessionCheck.h"

#include <vtkFieldData.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "DataFile.h"
#include "DiskFile.h"
#include "SessionFolder.h"
#include "SessionIndex.h"
#include "SessionJson.h"
#include "SessionRepair.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

// A ruined session of an hour must not fill the screen.
constexpr std::size_t kLinesKept = 50;
constexpr double kTimeTolerance_s = 1e-5;

class Check {
 public:
  Check(const fs::path& folder, SessionReport& report, const SessionProgress& progress)
      : folder_(folder), report_(report), progress_(progress) {}

  SessionFindings run() {
    found_.files = list_files(folder_);
    found_.measurements = read_measurements(folder_ / session_name::kMeasurements);
    found_.events = read_events(folder_ / session_name::kEvents);
    check_head();
    check_table(session_name::kMeasurements, found_.measurements);
    check_table(session_name::kEvents, found_.events);
    check_files();
    if (!found_.files.temporary.empty()) {
      problem(std::to_string(found_.files.temporary.size()) + " unfinished temporary file(s), the first " +
              relative(found_.files.temporary.front()));
    }
    check_pvd();
    count();
    return std::move(found_);
  }

 private:
  void problem(const std::string& text) {
    ++report_.problem_count;
    if (report_.problems.size() < kLinesKept) report_.problems.push_back(text);
  }

  std::string relative(const fs::path& file) const { return file.lexically_relative(folder_).string(); }

  void check_head() {
    const fs::path file = folder_ / session_name::kJson;
    if (!fs::exists(file)) {
      // Without its head, something else must show that this is a session.
      if (!found_.measurements.present) {
        throw InputError(folder_.string() +
                         ": no session here (neither session.json nor measurements.csv); name its folder");
      }
      problem("session.json is missing");
      return;
    }
    try {
      found_.head = read_session_json(file);
      found_.head_readable = true;
      if (!found_.head.complete && !found_.head.recovered) {
        problem("session.json: the recording was cut off (or still runs)");
      }
    } catch (const InputError& error) {
      problem(std::string("session.json: ") + error.what());
    }
  }

  template <class Row>
  void check_table(const char* name, const SessionTable<Row>& table) {
    if (!table.present) {
      problem(std::string(name) + " is missing");
      return;
    }
    if (!table.header_right) problem(std::string(name) + ":1: the header is not that of this table");
    for (const BadLine& bad : table.bad)
      problem(std::string(name) + ':' + std::to_string(bad.number) + ": " + bad.reason);
  }

  // Reads every data file and compares its stamp with its name and its row.
  void check_files() {
    std::map<long, double> time_of;
    for (const Measurement& row : found_.measurements.rows) time_of[row.frame] = row.time_s;
    std::size_t total = 0;
    for (const auto& frames : found_.files.frames) total += frames.size();
    total += found_.files.hand_blocks.size();

    std::size_t done = 0;
    std::size_t without_row = 0;
    for (const PartNames& names : kParts) {
      for (const long frame : found_.files.frames[static_cast<std::size_t>(names.part)]) {
        const auto row = time_of.find(frame);
        without_row += row == time_of.end() ? 1U : 0U;
        check_file(names.part, frame, row == time_of.end() ? nullptr : &row->second);
        if (progress_ && (++done % 64 == 0 || done == total)) progress_(done, total);
      }
    }
    for (const long block : found_.files.hand_blocks) {
      check_hand(block);
      if (progress_ && (++done % 64 == 0 || done == total)) progress_(done, total);
    }
    if (without_row > 0) {
      report_.notes.push_back(std::to_string(without_row) +
                              " data file(s) belong to no row of measurements.csv; they are kept, but listed nowhere");
    }
  }

  // A block of the recording of the hand carries its own number.
  void check_hand(long block) {
    check_readable(hand_file(block),
                   [&](const fs::path& file) { require_stamp(file, read_poly_file(file), "block", block); });
  }

  void check_file(SessionPart part, long frame, const double* time_s) {
    check_readable(part_file(part, frame), [&](const fs::path& file) {
      const vtkSmartPointer<vtkDataObject> data = read(part, file);
      require_stamp(file, data, "frame", frame);
      if (time_s && std::abs(stamped_time_s(data) - *time_s) > kTimeTolerance_s * std::max(1.0, std::abs(*time_s))) {
        throw InputError(file.string() + ": stamped " + csv_number(stamped_time_s(data)) + " s where its row says " +
                         csv_number(*time_s) + " s");
      }
    });
  }

  // A stamp is there and says `number`.
  static void require_stamp(const fs::path& file, vtkDataObject* data, const char* what, long number) {
    vtkFieldData* field = data->GetFieldData();
    if (!field->GetArray(array_name::kTime) || !field->GetArray(array_name::kFrameIndex) ||
        !field->GetArray(array_name::kSchemaVersion)) {
      throw InputError(file.string() + ": carries no stamp");
    }
    if (stamped_frame_index(data) != number) {
      throw InputError(file.string() + ": stamped as " + what + ' ' + std::to_string(stamped_frame_index(data)));
    }
  }

  // Runs `check` on a file of the session; what it throws is a problem of that file.
  template <class CheckFile>
  void check_readable(const std::string& name, CheckFile check) {
    const fs::path file = folder_ / name;
    try {
      check(file);
    } catch (const InputError& error) {
      // The text starts with the whole path: the session's own part of it is enough here.
      const std::string text = error.what();
      problem(name + text.substr(std::min(text.size(), file.string().size())));
      found_.unreadable.push_back(file);
    }
  }

  vtkSmartPointer<vtkDataObject> read(SessionPart part, const fs::path& file) {
    if (part != SessionPart::kFrame) return read_poly_file(file);
    const auto image = read_image_file(file);
    if (found_.pixel_size_um == 0.0) found_.pixel_size_um = image->GetSpacing()[0];
    return image;
  }

  // The list must name exactly the files that the rows have, each at its row's time.
  void check_pvd() {
    const fs::path file = folder_ / session_name::kPvd;
    if (!fs::exists(file)) {
      problem("session.pvd is missing");
      return;
    }
    std::set<std::pair<std::string, std::string>> listed;
    const bool readable = read_pvd(file, listed);
    if (!readable) {
      problem("session.pvd: not readable as XML");
      return;
    }
    std::set<std::pair<std::string, std::string>> expected;
    for (const SessionStep& step : make_steps(found_.measurements.rows, found_.files)) {
      for (const PartNames& names : kParts) {
        if (step.has(names.part)) expected.emplace(part_file(names.part, step.frame_index), csv_number(step.time_s));
      }
    }
    std::vector<std::pair<std::string, std::string>> missing;
    std::vector<std::pair<std::string, std::string>> extra;
    std::set_difference(expected.begin(), expected.end(), listed.begin(), listed.end(), std::back_inserter(missing));
    std::set_difference(listed.begin(), listed.end(), expected.begin(), expected.end(), std::back_inserter(extra));
    if (!missing.empty()) {
      problem("session.pvd: does not list " + std::to_string(missing.size()) + " file(s), the first " +
              missing.front().first);
    }
    if (!extra.empty()) {
      problem("session.pvd: lists " + std::to_string(extra.size()) +
              " file(s) that are not there at that time, the first " + extra.front().first);
    }
    found_.pvd_right = missing.empty() && extra.empty();
  }

  static bool read_pvd(const fs::path& file, std::set<std::pair<std::string, std::string>>& listed) {
    const std::string text = read_whole_file(file);
    // VTK's parser writes to stderr about anything else than a whole file.
    if (text.find("</VTKFile>") == std::string::npos) return false;
    auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(text.c_str()));
    vtkXMLDataElement* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
    if (!collection) return false;
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
      vtkXMLDataElement* entry = collection->GetNestedElement(i);
      const char* name = entry->GetAttribute("file");
      const char* time = entry->GetAttribute("timestep");
      if (!name || !time) return false;
      if (std::string(name) != session_name::kEmpty) listed.emplace(name, time);
    }
    return true;
  }

  // What is really there: readable files that belong to a row.
  void count() {
    SessionCounts& counts = report_.counts;
    counts.step_count = found_.measurements.rows.size();
    counts.event_count = found_.events.rows.size();
    counts.unmeasured_count = static_cast<std::uint64_t>(std::count_if(
        found_.measurements.rows.begin(), found_.measurements.rows.end(), [](const auto& row) { return !row.state; }));
    for (const Event& event : found_.events.rows) counts.dropped_count += dropped_frame_count(event);
    const std::set<fs::path> unreadable(found_.unreadable.begin(), found_.unreadable.end());
    for (const SessionStep& step : make_steps(found_.measurements.rows, found_.files)) {
      for (const PartNames& names : kParts) {
        const fs::path file = folder_ / part_file(names.part, step.frame_index);
        if (!step.has(names.part) || unreadable.contains(file)) continue;
        ++counts.file_count[static_cast<std::size_t>(names.part)];
        counts.byte_count += fs::file_size(file);
      }
    }
    for (const long block : found_.files.hand_blocks) {
      const fs::path file = folder_ / hand_file(block);
      if (unreadable.contains(file)) continue;
      ++counts.hand_block_count;
      counts.byte_count += fs::file_size(file);
    }
    // The rows count too, with their ends.
    counts.byte_count += measurement_header().size() + std::string_view(session_name::kEventsHeader).size() + 2;
    for (const auto* lines : {&found_.measurements.lines, &found_.events.lines}) {
      for (const std::string& line : *lines) counts.byte_count += line.size() + 1;
    }
    compare_counts(counts);
  }

  // What the head says must be so; of a recording that was cut off it says what was a second before.
  void compare_counts(const SessionCounts& counts) {
    if (!found_.head_readable || !(found_.head.complete || found_.head.recovered)) return;
    const SessionCounts& stated = found_.head.counts;
    const auto compare = [&](const std::string& what, std::uint64_t said, std::uint64_t is) {
      if (said != is) {
        problem("session.json: says " + std::to_string(said) + ' ' + what + ", there are " + std::to_string(is));
      }
    };
    compare("steps", stated.step_count, counts.step_count);
    compare("events", stated.event_count, counts.event_count);
    compare("files of the hand", stated.hand_block_count, counts.hand_block_count);
    for (const PartNames& names : kParts) {
      compare(std::string(names.folder) + " files", stated.files(names.part), counts.files(names.part));
    }
  }

  const fs::path folder_;
  SessionReport& report_;
  const SessionProgress& progress_;
  SessionFindings found_;
};

}  // namespace

SessionReport check_session(const fs::path& folder, bool repair, const SessionProgress& progress) {
  std::error_code status;
  if (!fs::is_directory(folder, status)) throw InputError(folder.string() + ": no such session folder; check the path");
  SessionReport report;
  const SessionFindings findings = Check(folder, report, progress).run();
  if (repair && report.problem_count > 0) repair_session(folder, findings, report);
  return report;
}

}  // namespace pellucida
