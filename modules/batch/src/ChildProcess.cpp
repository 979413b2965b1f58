#include "pellucida/batch/ChildProcess.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr off_t kMostErrorBytes = 64 * 1024;
constexpr int kNotStarted = 127;  // as a shell says it

// In the child, between fork and exec: only what a signal handler may call.
[[noreturn]] void become(const char* program, char* const* arguments, int nothing, int errors, pid_t parent) noexcept {
  ::setpgid(0, 0);
  // The end of the parent is the child's; where that came before the call, it is noticed here.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kNotStarted);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  ::execv(program, arguments);
  const char* reason = std::strerror(errno);
  for (const char* text : {"pellucida: ", program, " can't be started: ", reason, "\n"}) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
  }
  ::_exit(kNotStarted);
}

[[noreturn]] void refuse(const char* what) {
  throw OutputError(std::string("a program can't be run beside this one: ") + what + " (" + std::strerror(errno) +
                    "); end other programs, or lower --jobs");
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  const std::string path = program.string();
  std::vector<char*> words{const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);

  error_descriptor_ = ::memfd_create("pellucida-errors", MFD_CLOEXEC);
  if (error_descriptor_ < 0) refuse("no memory for its messages");
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  const pid_t parent = ::getpid();
  pid_ = nothing < 0 ? -1 : ::fork();
  if (pid_ == 0) become(path.c_str(), words.data(), nothing, error_descriptor_, parent);
  const int reason = errno;
  if (nothing >= 0) ::close(nothing);
  if (pid_ < 0) {
    ::close(error_descriptor_);
    errno = reason;
    refuse("no process");
  }
  // glibc 2.36 declares its own function without C linkage. Where there is none, `poll` passes over -1.
  end_descriptor_ = static_cast<int>(::syscall(SYS_pidfd_open, pid_, 0));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      end_descriptor_(std::exchange(other.end_descriptor_, -1)),
      error_descriptor_(std::exchange(other.error_descriptor_, -1)),
      start_(other.start_) {}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  for (const int descriptor : {end_descriptor_, error_descriptor_}) {
    if (descriptor >= 0) ::close(descriptor);
  }
}

std::optional<ChildEnd> ChildProcess::end() {
  int status = 0;
  if (pid_ <= 0 || ::waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
  pid_ = -1;
  ChildEnd end;
  end.wall_time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  end.exit_code = end.signal != 0 ? 128 + end.signal : WEXITSTATUS(status);
  end.error_output = error_output();
  return end;
}

void ChildProcess::send(int signal) const noexcept {
  if (pid_ > 0) ::kill(pid_, signal);
}

std::string ChildProcess::error_output() const {
  const off_t size = ::lseek(error_descriptor_, 0, SEEK_END);
  if (size <= 0) return {};
  const off_t start = std::max<off_t>(0, size - kMostErrorBytes);
  std::string text(static_cast<std::size_t>(size - start), '\0');
  const ssize_t count = ::pread(error_descriptor_, text.data(), text.size(), start);
  text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  return text;
}

}  // namespace pellucida
