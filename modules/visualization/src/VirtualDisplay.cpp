#include "pellucida/visualization/VirtualDisplay.h"

#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr int kStartTimeout_ms = 20000;

[[noreturn]] void fail(const std::string& reason) {
  throw DeviceError("no display to draw with, and " + reason +
                    ": set DISPLAY to a running X server, or install the package xvfb (apt-get install xvfb)");
}

// The child's part: become Xvfb. Only calls that are safe between fork and exec.
[[noreturn]] void become_server(pid_t parent, const char* display_fd) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);
  // Its own group, so that Ctrl-C in the terminal reaches us first and the server goes when we let it go.
  setpgid(0, 0);
  const int null = open("/dev/null", O_RDWR);
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  execlp("Xvfb", "Xvfb", "-displayfd", display_fd, "-screen", "0", "2048x1280x24", "-nolisten", "tcp", "-noreset",
         "+extension", "GLX", static_cast<char*>(nullptr));
  _exit(127);
}

// The number the server chose, or nothing when it ended or kept silent.
std::string read_display_number(int fd) {
  std::string text;
  std::array<char, 16> buffer{};
  while (text.empty() || text.back() != '\n') {
    pollfd wanted{.fd = fd, .events = POLLIN, .revents = 0};
    if (poll(&wanted, 1, kStartTimeout_ms) <= 0) return {};
    const ssize_t count = read(fd, buffer.data(), buffer.size());
    if (count <= 0) return {};
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  text.pop_back();
  return text;
}

void end_server(pid_t server) noexcept {
  kill(server, SIGTERM);
  waitpid(server, nullptr, 0);
}

}  // namespace

bool display_answers(const char* display) noexcept {
  if (!display && !std::getenv("DISPLAY")) return false;
  Display* connection = XOpenDisplay(display);
  if (!connection) return false;
  XCloseDisplay(connection);
  return true;
}

VirtualDisplay::VirtualDisplay() {
  if (display_answers()) return;
  const char* old = std::getenv("DISPLAY");
  had_display_ = old != nullptr;
  if (old) old_display_ = old;

  // The server writes the number of the display it took into the pipe.
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) fail("no pipe could be made");
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const std::string write_end = std::to_string(ends[1]);
  const pid_t parent = getpid();
  server_ = fork();
  if (server_ == 0) become_server(parent, write_end.c_str());
  close(ends[1]);
  const std::string number = server_ > 0 ? read_display_number(ends[0]) : std::string{};
  close(ends[0]);

  if (number.empty()) {
    if (server_ > 0) end_server(server_);
    server_ = 0;
    fail("Xvfb could not be started");
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
  std::fprintf(stderr, "%s; drawing on a private Xvfb at :%s\n",
               had_display_ ? ("display " + old_display_ + " does not answer").c_str() : "no display", number.c_str());
}

VirtualDisplay::~VirtualDisplay() {
  if (server_ <= 0) return;
  if (had_display_) {
    setenv("DISPLAY", old_display_.c_str(), 1);
  } else {
    unsetenv("DISPLAY");
  }
  end_server(server_);
}

}  // namespace pellucida
