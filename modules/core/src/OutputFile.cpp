#include "pellucida/core/OutputFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "pellucida/core/NewFiles.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferBytes = 1U << 18U;
constexpr int kMostNames = 1000;

// What is written to must not be what is read: a new file, no link followed.
int make_temporary(const fs::path& target, fs::path& temporary) {
  for (int i = 0; i < kMostNames; ++i) {
    temporary = target;
    if (i > 0) temporary += '.' + std::to_string(i);
    temporary += kTemporarySuffix;
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

// The end of a chain of links; the name itself where it is no link, or one that leads nowhere yet.
fs::path link_target(const fs::path& file) {
  std::error_code code;
  if (!fs::is_symlink(file, code)) return file;
  const fs::path target = fs::weakly_canonical(file, code);
  return code ? file : target;
}

}  // namespace

OutputError disk_error(const fs::path& path, int reason) {
  std::string help = "choose another folder";
  if (reason == ENOSPC || reason == EDQUOT) help = "free some space, or choose another disk";
  if (reason == EFBIG) help = "raise the file size limit, or choose another disk";
  if (reason == EACCES || reason == EPERM || reason == EROFS) help = "change its permission, or choose another folder";
  return OutputError(path.string() + ": can't be written (" + std::generic_category().message(reason) + "); " + help);
}

void make_folder(const fs::path& folder) {
  std::error_code reason;
  fs::create_directories(folder, reason);
  if (!reason && !fs::is_directory(folder)) reason = std::make_error_code(std::errc::not_a_directory);
  if (reason) throw disk_error(folder, reason.value());
}

OutputFile::OutputFile(const fs::path& file, Link link)
    : file_(file), target_(link == Link::kFollow ? link_target(file) : file) {
  struct stat status {};
  const bool there = link == Link::kFollow && ::stat(target_.c_str(), &status) == 0;
  if (there && S_ISDIR(status.st_mode)) throw disk_error(file_, EISDIR);
  if (there && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    descriptor_ = make_temporary(target_, temporary_);
    // The new file gets the rights of the one that it replaces.
    if (there && descriptor_ >= 0) {
      [[maybe_unused]] const int result = ::fchmod(descriptor_, status.st_mode & 07777);
    }
  }
  if (descriptor_ < 0) {
    temporary_.clear();
    throw disk_error(file_, errno);
  }
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= kBufferBytes) flush_buffer();
}

void OutputFile::add(std::string_view line) {
  buffer_ += line;
  write("\n");
}

void OutputFile::flush_buffer() {
  std::string_view left = buffer_;
  while (!left.empty()) {
    const ssize_t count = ::write(descriptor_, left.data(), left.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw disk_error(file_, errno);
    left.remove_prefix(static_cast<std::size_t>(count));
  }
  buffer_.clear();
}

void OutputFile::finish(bool flushed) {
  flush_buffer();
  // Some file systems report a full disk only here.
  int reason = flushed && !temporary_.empty() && ::fsync(descriptor_) != 0 ? errno : 0;
  if (::close(descriptor_) != 0 && reason == 0) reason = errno;
  descriptor_ = -1;
  if (reason == 0 && !temporary_.empty()) {
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) reason = errno;
    if (reason == 0) temporary_.clear();
  }
  if (reason != 0) throw disk_error(file_, reason);
}

void replace_file(const fs::path& file, std::string_view content) {
  OutputFile output(file, OutputFile::Link::kReplace);
  output.write(content);
  output.finish(false);
}

void require_new(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    std::error_code ignored;
    if (file.empty() || !fs::is_regular_file(file, ignored)) continue;
    throw UsageError(file.string() + ": already there; give another --output, or --replace to replace it");
  }
}

void require_apart(const fs::path& output, const fs::path& input, const std::string& option) {
  std::error_code code;
  if (output.empty() || input.empty() || !fs::equivalent(output, input, code) || code) return;
  throw UsageError(option + ' ' + output.string() + ": is the input " + input.string() +
                   ", which would be overwritten; name another file");
}

}  // namespace pellucida
