#include "DiskFile.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>

#include "SessionLock.h"

namespace pellucida {
namespace {

// All of `content`, or the system's reason (0 = done).
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

}  // namespace

std::string read_whole_file(const std::filesystem::path& file, std::uint64_t most_bytes) {
  // Without waiting for the other end of a pipe.
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0) {
    const std::string reason =
        errno == ELOOP ? "a link, which is not followed" : std::generic_category().message(errno);
    throw InputError(file.string() + ": can't be read (" + reason + ")");
  }
  struct stat status {};
  std::string content;
  std::string reason;
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    reason = "a folder, pipe or device, not a file";
  } else if (static_cast<std::uint64_t>(status.st_size) > most_bytes) {
    reason = std::to_string(status.st_size) + " bytes where at most " + std::to_string(most_bytes) + " are expected";
  } else {
    content.resize(static_cast<std::size_t>(status.st_size));
    std::size_t done = 0;
    while (done < content.size() && reason.empty()) {
      const ssize_t count = ::read(descriptor, content.data() + done, content.size() - done);
      if (count > 0) done += static_cast<std::size_t>(count);
      if (count == 0) break;
      if (count < 0 && errno != EINTR) reason = std::generic_category().message(errno);
    }
    content.resize(done);
  }
  ::close(descriptor);
  if (!reason.empty()) throw InputError(file.string() + ": can't be read (" + reason + ")");
  return content;
}

bool is_present(const std::filesystem::path& file) {
  std::error_code code;
  const auto type = std::filesystem::symlink_status(file, code).type();
  return type != std::filesystem::file_type::not_found && type != std::filesystem::file_type::none;
}

bool is_plain_file(const std::filesystem::path& file) {
  std::error_code code;
  return std::filesystem::symlink_status(file, code).type() == std::filesystem::file_type::regular;
}

void for_each_entry(const std::filesystem::path& folder, const std::function<void(const char*, bool)>& use) {
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(folder.c_str()), &::closedir);
  if (!entries) return;
  // The kind comes with the name, so that no file is touched; some file systems don't have it there.
  while (const dirent* entry = ::readdir(entries.get())) {
    const bool known = entry->d_type != DT_UNKNOWN;
    use(entry->d_name, known ? entry->d_type == DT_REG : is_plain_file(folder / entry->d_name));
  }
}

AppendFile::AppendFile(const std::filesystem::path& file, std::string_view header) : file_(file) {
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor_ < 0) throw disk_error(file_, errno);
  try {
    append(header);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

AppendFile::~AppendFile() {
  ::close(descriptor_);
}

void AppendFile::shrink_to(std::uint64_t byte_count) noexcept {
  if (::ftruncate(descriptor_, static_cast<off_t>(byte_count)) == 0) byte_count_ = byte_count;
}

void AppendFile::lock() noexcept {
  lock_file(descriptor_);
}

void AppendFile::unlock() noexcept {
  ::flock(descriptor_, LOCK_UN);
}

void AppendFile::append(std::string_view line) {
  std::string whole(line);
  whole += '\n';
  const int reason = write_all(descriptor_, whole);
  if (reason != 0) {
    // Half a line would spoil the table: back to the last whole one (and if even that fails, the check mends it).
    [[maybe_unused]] const int result = ::ftruncate(descriptor_, static_cast<off_t>(byte_count_));
    throw disk_error(file_, reason);
  }
  byte_count_ += whole.size();
}

}  // namespace pellucida
