#include "ResultPlace.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "pellucida/batch/RecordingList.h"
#include "pellucida/core/OutputFile.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

void move_folder(const fs::path& from, const fs::path& to) {
  std::error_code fault;
  fs::rename(from, to, fault);
  if (fault) throw disk_error(to, fault.value());
}

}  // namespace

fs::path record_file(const fs::path& output, const std::string& name) {
  return output / batch_name::kRecords / (name + ".json");
}

ResultPlace::ResultPlace(const fs::path& output, const std::string& name)
    : output_(output), name_(name), place_(output / batch_name::kUnfinished / name) {
  make_folder(place_);
  lock_ = ::open(place_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) throw disk_error(place_, errno);
  // On a file system without locks there is nothing to hold.
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(lock_);
    lock_ = -1;
    return;
  }
  std::error_code fault;
  for (const auto& entry : fs::directory_iterator(place_, fault)) {
    fs::remove_all(entry.path(), fault);
    if (fault) throw disk_error(entry.path(), fault.value());
  }
}

ResultPlace::~ResultPlace() {
  if (lock_ < 0) return;
  std::error_code ignored;
  fs::remove_all(place_, ignored);
  ::close(lock_);
}

void ResultPlace::publish(const RecordingRecord& record) {
  const fs::path result = output_ / name_;
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(result, ignored))) {
    if (record.session_sha256.empty()) return;
    move_folder(result, place_ / "older");
  }
  make_folder(output_ / batch_name::kRecords);
  write_record(record_file(output_, name_), record);
  if (!record.session_sha256.empty()) move_folder(work(), result);
}

}  // namespace pellucida
