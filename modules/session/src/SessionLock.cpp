#include "SessionLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "SessionFolder.h"

namespace pellucida {

bool lock_file(int descriptor) noexcept {
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

SessionLock::SessionLock(const std::filesystem::path& session) {
  const std::filesystem::path file = session / session_name::kMeasurements;
  constexpr int kFlags = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY;
  // Network file systems want to be able to write what they lock.
  descriptor_ = ::open(file.c_str(), O_RDWR | kFlags);
  if (descriptor_ < 0) descriptor_ = ::open(file.c_str(), O_RDONLY | kFlags);
  refused_ = descriptor_ >= 0 && !lock_file(descriptor_);
}

SessionLock::~SessionLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace pellucida
