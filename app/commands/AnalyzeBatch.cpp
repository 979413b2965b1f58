#include "commands/AnalyzeBatch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

#include "commands/Interrupt.h"
#include "pellucida/batch/Groups.h"
#include "pellucida/batch/OverviewPage.h"
#include "pellucida/batch/RecordingBatch.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Progress.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/Version.h"
#include "pellucida/session/SessionSource.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

constexpr const char* kByFolder = "folder";
constexpr std::chrono::seconds kSummaryPeriod{5};  // so old a summary may be after a kill

using Rows = std::span<const BatchRow>;

void check_output(const BatchArguments& arguments) {
  if (is_session(arguments.output)) {
    throw UsageError("--output " + arguments.output + ": a session; a batch needs a folder of its own");
  }
  std::error_code ignored;
  for (const std::string& input : arguments.inputs) {
    if (fs::equivalent(input, arguments.output, ignored)) {
      throw UsageError("--output " + arguments.output +
                       ": the folder of the recordings; give another, or one below it");
    }
  }
}

// Only the recordings named; a name that there isn't is a mistake.
void choose(const std::vector<std::string>& names, std::vector<Recording>& recordings) {
  for (const std::string& name : names) {
    if (std::none_of(recordings.begin(), recordings.end(), [&](const auto& r) { return r.name == name; })) {
      throw UsageError("--only " + name + ": no recording of that name; --list prints the names");
    }
  }
  std::erase_if(recordings,
                [&](const auto& r) { return std::find(names.begin(), names.end(), r.name) == names.end(); });
}

void print_list(const std::vector<Recording>& recordings, const BatchSettings& settings) {
  std::cout << "name,input,state\n";
  for (const Recording& recording : recordings) {
    std::cout << csv_cell(recording.name) << ',' << csv_cell(recording.input) << ','
              << (is_finished(recording, settings) ? "finished" : "to do") << '\n';
  }
}

std::string time_left(double left_s) {
  if (std::isnan(left_s)) return "";
  const long minutes = std::lround(left_s / 60.0);
  if (left_s < 90.0) return ", about " + std::to_string(std::max(1L, std::lround(left_s))) + " s left";
  if (minutes < 90) return ", about " + std::to_string(minutes) + " min left";
  return ", about " + std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min left";
}

std::string progress_line(const BatchProgress& progress) {
  std::string line = std::to_string(progress.done_count) + " of " + std::to_string(progress.all_count) + " recordings";
  if (progress.failed_count > 0) line += ", " + std::to_string(progress.failed_count) + " failed";
  return line + time_left(progress.left_s);
}

/// The files beside the results.
class BatchFiles {
 public:
  BatchFiles(const BatchArguments& arguments, std::vector<std::string> groups)
      : output_(arguments.output), grouped_(!arguments.group_by.empty()), groups_(std::move(groups)) {
    const fs::path folder = fs::absolute(arguments.inputs.front()).lexically_normal();
    title_ = arguments.inputs.size() > 1 ? std::to_string(arguments.inputs.size()) + " inputs"
             : folder.has_filename()     ? folder.filename().string()
                                         : folder.parent_path().filename().string();
  }

  /// The table, now and then while the batch runs.
  void keep_up(Rows rows) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < kSummaryPeriod) return;
    write_summary(rows);
    last_ = now;
  }

  /// All files; says where they are.
  void write(Rows rows) {
    write_summary(rows);
    std::cout << "summary   " << (output_ / batch_name::kSummary).string() << '\n';
    std::vector<GroupRow> compared;
    if (grouped_) {
      const auto names = groups_.empty() ? groups_of(rows) : groups_;
      compared = compare_groups(rows, names);
      write_whole(batch_name::kGroups, groups_csv(compared));
      std::cout << "groups    " << (output_ / batch_name::kGroups).string() << '\n';
    } else {
      // Of an earlier call: no longer what the page shows.
      std::error_code ignored;
      fs::remove(output_ / batch_name::kGroups, ignored);
    }
    const std::string page = overview_page("Recordings of " + title_, rows, compared);
    write_whole(batch_name::kOverview, page);
    write_whole(batch_name::kReport, page);
    std::cout << "overview  " << (output_ / batch_name::kOverview).string() << '\n';
  }

 private:
  void write_summary(Rows rows) { write_whole(batch_name::kSummary, summary_csv(rows)); }

  void write_whole(const char* name, const std::string& text) const {
    OutputFile file(output_ / name);
    file.write(text);
    file.finish();
  }

  fs::path output_;
  bool grouped_;
  std::vector<std::string> groups_;
  std::string title_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// "200 recordings: 190 measured, 10 failed"
std::string count_line(Rows rows) {
  std::map<std::string, int> counts;
  for (const BatchRow& row : rows) ++counts[row.result];
  std::string line = std::to_string(rows.size()) + (rows.size() == 1 ? " recording" : " recordings");
  const char* separator = ": ";
  for (const char* result : {batch_result::kMeasured, batch_result::kDamaged, batch_result::kNothing,
                             batch_result::kFailed, batch_result::kWaiting}) {
    if (counts[result] == 0) continue;
    line += separator + std::to_string(counts[result]) + ' ' + result;
    separator = ", ";
  }
  return line;
}

void require_all_measured(Rows rows, const BatchArguments& arguments) {
  const auto rest =
      std::count_if(rows.begin(), rows.end(), [](const auto& r) { return r.result != batch_result::kMeasured; });
  if (rest == 0) return;
  const std::string where = arguments.only.empty()
                                ? (fs::path(arguments.output) / batch_name::kSummary).string() + " says why"
                                : "the lines above say why";
  throw SomeFailedError(std::to_string(rest) + " of " + std::to_string(rows.size()) +
                        " recordings were not measured to their end; " + where);
}

}  // namespace

void analyze_batch(const BatchArguments& arguments) {
  if (arguments.list + arguments.collect + !arguments.only.empty() > 1) {
    throw UsageError("--list, --collect and --only exclude each other");
  }
  check_output(arguments);
  RecordingList found = find_recordings(arguments.inputs, arguments.output);
  std::vector<std::string> groups;
  if (!arguments.group_by.empty() && arguments.group_by != kByFolder) {
    Conditions conditions = take_conditions(arguments.group_by, found.recordings);
    groups = std::move(conditions.groups);
    found.notes.insert(found.notes.end(), conditions.notes.begin(), conditions.notes.end());
  }
  if (arguments.only.empty()) {
    for (const std::string& note : found.notes) std::cerr << "pellucida: " << note << '\n';
  } else {
    choose(arguments.only, found.recordings);
  }

  BatchSettings settings;
  settings.program = fs::read_symlink("/proc/self/exe");
  settings.output = arguments.output;
  settings.recipe = {arguments.options, arguments.profile_sha256, kVersion};
  settings.job_count = arguments.job_count;
  settings.again = arguments.again;
  settings.only_collect = arguments.collect;
  if (arguments.list) return print_list(found.recordings, settings);

  const InterruptScope interrupt;
  BatchFiles files(arguments, std::move(groups));
  std::vector<BatchRow> rows;
  {
    Progress progress("recording");
    settings.stop_signal = interrupted;
    settings.progress = [&](const BatchProgress& now) { progress.say(progress_line(now)); };
    settings.finished = [&](Rows all, const BatchRow& row) {
      if (!row.error.empty()) progress.note(row.name + ": " + row.error);
      if (arguments.only.empty()) files.keep_up(all);
    };
    rows = run_recordings(found.recordings, settings);
  }
  std::cout << count_line(rows) << '\n';
  if (arguments.only.empty()) files.write(rows);
  if (interrupted() == 0) require_all_measured(rows, arguments);
}

}  // namespace pellucida
