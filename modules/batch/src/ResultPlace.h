#pragma once
#include <filesystem>
#include <string>

#include "pellucida/batch/RecordingRecord.h"

namespace pellucida {

/// Where the result of one recording is made, and moved to once it is whole. One of them at a time, in all programs:
/// the second finds it taken.
class ResultPlace {
 public:
  /// Makes an empty folder below `output/.unfinished`, what an earlier program left in it is gone. Throws OutputError.
  ResultPlace(const std::filesystem::path& output, const std::string& name);
  /// What was not published is removed.
  ~ResultPlace();
  ResultPlace(const ResultPlace&) = delete;
  ResultPlace& operator=(const ResultPlace&) = delete;

  /// False where another program is at work on the same result: nothing may be done.
  bool is_ours() const noexcept { return lock_ >= 0; }
  /// For the session.
  std::filesystem::path work() const { return place_ / "session"; }

  /// The record, and the session it is about in place of an older one. Killed in between, the program leaves a record
  /// whose session isn't there, and makes that one again. A failure leaves an older result as it is, with its record.
  /// Throws OutputError.
  void publish(const RecordingRecord& record);

 private:
  std::filesystem::path output_;
  std::string name_;
  std::filesystem::path place_;
  int lock_ = -1;
};

/// `output/records/NAME.json`
std::filesystem::path record_file(const std::filesystem::path& output, const std::string& name);

}  // namespace pellucida
