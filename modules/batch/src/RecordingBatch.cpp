#include "pellucida/batch/RecordingBatch.h"

#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <list>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ResultPlace.h"
#include "pellucida/batch/ChildProcess.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/session/SessionSource.h"
#include "pellucida/session/Sha256.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

constexpr int kTurn_ms = 100;  // how often a stop and the progress are looked at

/// One recording while it is analysed.
struct Job {
  std::size_t index;
  InputStamp stamp;
  std::unique_ptr<ResultPlace> place;
  ChildProcess child;
};

// The program's own line of error; where it had no time for one, what ended it and its last words.
std::string error_line(const ChildEnd& end) {
  constexpr std::string_view kStart = "pellucida: ";
  std::string own, last;
  std::istringstream lines(end.error_output);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kStart)) own = line.substr(kStart.size());
    if (!line.empty()) last = line;
  }
  if (end.signal == 0) return own.empty() ? last : own;
  std::string text =
      std::string("ended by signal ") + std::to_string(end.signal) + " (" + ::strsignal(end.signal) + ")";
  if (end.signal == SIGKILL) text += ", as the system does when memory runs out";
  return last.empty() ? text : text + "; its last words: " + last;
}

// Of the file that was analysed: the session says it.
std::string input_hash(const fs::path& session) {
  try {
    const auto provenance = nlohmann::json::parse(SessionReader(session).info().provenance_json);
    return provenance.value("/inputs_sha256/file"_json_pointer, std::string());
  } catch (const std::exception&) {
    return {};
  }
}

bool is_closed_session(const fs::path& folder) {
  try {
    return is_session(folder) && SessionReader(folder).complete();
  } catch (const InputError&) {
    return false;
  }
}

// The record of a recording that needs no work: its result is whole and up to date. Where only collected, a failure
// counts too.
std::optional<RecordingRecord> finished_record(const Recording& recording, const BatchSettings& settings) {
  auto record = read_record(record_file(settings.output, recording.name));
  if (!record || record->recipe != settings.recipe) return std::nullopt;
  const bool failed = record->session_sha256.empty();
  if (failed ? !settings.only_collect : !holds_result(settings.output / recording.name, *record)) return std::nullopt;
  if (!same_content(record->input, stamp_of(recording.input))) return std::nullopt;
  return record;
}

// What is known to be the same after reading it: next time its stamp will do.
void refresh_stamp(const Recording& recording, const fs::path& output, RecordingRecord record) {
  InputStamp now = stamp_of(recording.input);
  if (now.path == record.input.path && now.modified_ns == record.input.modified_ns) return;
  now.sha256 = record.input.sha256;
  record.input = now;
  write_record(record_file(output, recording.name), record);
}

class Batch {
 public:
  Batch(const std::vector<Recording>& recordings, const BatchSettings& settings)
      : recordings_(recordings), settings_(settings) {
    for (const Recording& recording : recordings) {
      rows_.push_back(make_row(recording, std::nullopt, settings.output));
      // A recording takes time even where it has no size.
      bytes_.push_back(1.0 + static_cast<double>(stamp_of(recording.input).byte_count));
      all_bytes_ += bytes_.back();
    }
  }

  std::vector<BatchRow> run() {
    std::vector<std::size_t> queue = take_finished();
    if (settings_.only_collect) queue.clear();
    std::reverse(queue.begin(), queue.end());
    while (!queue.empty() || !jobs_.empty()) {
      if (const int number = stop_signal(); number != 0) {
        queue.clear();
        if (!stopping_) {
          for (const Job& job : jobs_) job.child.send(number);
        }
        stopping_ = true;
      }
      while (!queue.empty() && static_cast<int>(jobs_.size()) < settings_.job_count) {
        start(queue.back());
        queue.pop_back();
      }
      wait();
      collect();
      show();
    }
    std::error_code ignored;
    fs::remove(settings_.output / batch_name::kUnfinished, ignored);  // only if empty
    return std::move(rows_);
  }

 private:
  int stop_signal() const { return settings_.stop_signal ? settings_.stop_signal() : 0; }

  // Rows of what is there; the indices of what is to be done.
  std::vector<std::size_t> take_finished() {
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < recordings_.size(); ++i) {
      const auto record = finished_record(recordings_[i], settings_);
      if (record && (!settings_.again || settings_.only_collect)) {
        refresh_stamp(recordings_[i], settings_.output, *record);
        finish(i, *record, 0.0);
      } else {
        rest.push_back(i);
      }
    }
    return rest;
  }

  void start(std::size_t index) {
    const Recording& recording = recordings_[index];
    auto place = std::make_unique<ResultPlace>(settings_.output, recording.name);
    if (!place->is_ours())
      return refuse(index, "another program is analysing it into the same folder; wait for its end");
    if (!may_replace(recording)) {
      return refuse(index, (settings_.output / recording.name).string() +
                               ": holds something that this batch did not make, or that was changed since; move it "
                               "away, or give another --output");
    }
    std::vector<std::string> arguments{"analyze", recording.input, "--output", place->work().string()};
    arguments.insert(arguments.end(), settings_.recipe.options.begin(), settings_.recipe.options.end());
    InputStamp stamp = stamp_of(recording.input);
    jobs_.push_back({index, std::move(stamp), std::move(place), ChildProcess(settings_.program, arguments)});
  }

  bool may_replace(const Recording& recording) const {
    const fs::path result = settings_.output / recording.name;
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(result, ignored))) return true;
    const auto record = read_record(record_file(settings_.output, recording.name));
    return record && holds_result(result, *record);
  }

  void wait() const {
    if (jobs_.empty()) return;
    std::vector<pollfd> ends;
    for (const Job& job : jobs_) ends.push_back({.fd = job.child.end_descriptor(), .events = POLLIN, .revents = 0});
    // A signal ends the wait early.
    ::poll(ends.data(), ends.size(), kTurn_ms);
  }

  void collect() {
    for (auto job = jobs_.begin(); job != jobs_.end();) {
      const auto end = job->child.end();
      if (!end) {
        ++job;
        continue;
      }
      // After a stop nobody can tell a whole result from one cut short, other than by its good end.
      if (!stopping_ || end->exit_code == 0) publish(*job, *end);
      job = jobs_.erase(job);
    }
  }

  void publish(const Job& job, const ChildEnd& end) {
    // A full disk is full for the others too, and each would find out only after its work.
    if (end.exit_code == static_cast<int>(ExitCode::kOutputUnwritable)) throw OutputError(error_line(end));
    RecordingRecord record;
    record.input = job.stamp;
    record.recipe = settings_.recipe;
    record.exit_code = end.exit_code;
    record.error = end.exit_code == 0 ? std::string() : error_line(end);
    record.wall_time_s = end.wall_time_s;
    const fs::path session = job.place->work();
    if (end.signal == 0 && is_closed_session(session)) {
      record.session_sha256 = sha256_of_file(session / "session.json");
      record.input.sha256 = input_hash(session);
    }
    job.place->publish(record);
    // What failed at once says nothing of the time that the others need.
    finish(job.index, record, record.session_sha256.empty() ? 0.0 : bytes_[job.index]);
  }

  // A failure that leaves no record: it is about the output, not about the recording.
  void refuse(std::size_t index, const std::string& error) {
    RecordingRecord record;
    record.exit_code = static_cast<int>(ExitCode::kOutputUnwritable);
    record.error = error;
    finish(index, record, 0.0);
  }

  void finish(std::size_t index, const RecordingRecord& record, double worked_bytes) {
    BatchRow& row = rows_[index];
    row = make_row(recordings_[index], record, settings_.output);
    ++progress_.done_count;
    if (row.result != batch_result::kMeasured) ++progress_.failed_count;
    worked_bytes_ += worked_bytes;
    if (worked_bytes == 0.0) all_bytes_ -= bytes_[index];
    if (settings_.finished) settings_.finished(rows_, row);
  }

  void show() {
    if (!settings_.progress) return;
    progress_.all_count = static_cast<int>(recordings_.size());
    const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    progress_.left_s = estimate_left_s(elapsed_s, worked_bytes_, all_bytes_);
    settings_.progress(progress_);
  }

  const std::vector<Recording>& recordings_;
  const BatchSettings& settings_;
  std::vector<BatchRow> rows_;
  std::vector<double> bytes_;  ///< of each recording
  double all_bytes_ = 0.0;     ///< of those that are neither kept nor failed
  double worked_bytes_ = 0.0;
  std::list<Job> jobs_;
  bool stopping_ = false;
  BatchProgress progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

double estimate_left_s(double elapsed_s, double done_bytes, double all_bytes) noexcept {
  if (!(done_bytes > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return elapsed_s * std::max(0.0, all_bytes - done_bytes) / done_bytes;
}

bool is_finished(const Recording& recording, const BatchSettings& settings) {
  return finished_record(recording, settings).has_value();
}

std::vector<BatchRow> run_recordings(const std::vector<Recording>& recordings, const BatchSettings& settings) {
  make_folder(settings.output);
  return Batch(recordings, settings).run();
}

}  // namespace pellucida
