#include "DiskFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

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

OutputError disk_error(const std::filesystem::path& path, int reason) {
  std::string help = "choose another folder with --output";
  if (reason == ENOSPC || reason == EDQUOT) help = "free some space, or choose another disk with --output";
  if (reason == EFBIG) help = "raise the file size limit, or choose another disk with --output";
  if (reason == EACCES || reason == EPERM || reason == EROFS) help = "change its permission, or choose another folder";
  return OutputError(path.string() + ": can't be written (" + std::generic_category().message(reason) + "); " + help);
}

void replace_file(const std::filesystem::path& file, std::string_view content) {
  const std::string temporary = file.string() + kTemporarySuffix;
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) throw disk_error(file, errno);
  int reason = write_all(descriptor, content);
  // Some file systems report a full disk only here.
  if (::close(descriptor) != 0 && reason == 0) reason = errno;
  if (reason == 0 && std::rename(temporary.c_str(), file.c_str()) != 0) reason = errno;
  if (reason != 0) {
    ::unlink(temporary.c_str());
    throw disk_error(file, reason);
  }
}

std::string read_whole_file(const std::filesystem::path& file) {
  std::error_code status;
  if (std::filesystem::is_directory(file, status)) throw InputError(file.string() + ": a folder, not a file");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    const std::string reason = errno != 0 ? std::generic_category().message(errno) : "unknown reason";
    throw InputError(file.string() + ": can't be read (" + reason + ")");
  }
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code reason;
  std::filesystem::create_directories(folder, reason);
  if (!reason && !std::filesystem::is_directory(folder)) reason = std::make_error_code(std::errc::not_a_directory);
  if (reason) throw disk_error(folder, reason.value());
}

AppendFile::AppendFile(const std::filesystem::path& file, std::string_view header) : file_(file) {
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
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
