#pragma once
#include <filesystem>

namespace pellucida {

/// Held on a session by whoever changes it: the writer while it records (AppendFile::lock), a repair. The system takes
/// it back when its holder ends, however that happens.
class SessionLock {
 public:
  /// Tries to take it. Without `measurements.csv`, or on a file system without locks, there is nothing to hold.
  explicit SessionLock(const std::filesystem::path& session);
  ~SessionLock();
  SessionLock(const SessionLock&) = delete;
  SessionLock& operator=(const SessionLock&) = delete;

  /// Another holds it: a program is recording into the session, or repairing it.
  bool refused() const noexcept { return refused_; }

 private:
  int descriptor_ = -1;
  bool refused_ = false;
};

/// Takes the lock on an open file; false where another has it.
bool lock_file(int descriptor) noexcept;

}  // namespace pellucida
