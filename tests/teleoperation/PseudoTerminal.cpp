#include "teleoperation/PseudoTerminal.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <stdexcept>
#include <string>

// libserialport accepts a port when the system lists it (/sys/class/tty/NAME is a link) and it has modem lines
// (TIOCMGET works). A pseudo-terminal has neither. These three functions replace the C library's for this test program
// and answer those questions for pseudo-terminals alone; everything else goes to the system as it is.
namespace {

constexpr const char* kListedPseudoTerminals = "/sys/class/tty/pts/";

bool is_listed_pseudo_terminal(const char* path) {
  return std::strncmp(path, kListedPseudoTerminals, std::strlen(kListedPseudoTerminals)) == 0;
}

bool is_modem_request(unsigned long request) {
  return request == TIOCMGET || request == TIOCMSET || request == TIOCMBIS || request == TIOCMBIC;
}

}  // namespace

extern "C" int __lxstat(int, const char* path, struct stat* info) {
  if (is_listed_pseudo_terminal(path)) {
    *info = {};
    info->st_mode = S_IFLNK;
    return 0;
  }
  return fstatat(AT_FDCWD, path, info, AT_SYMLINK_NOFOLLOW);
}

extern "C" ssize_t readlink(const char* path, char* into, std::size_t capacity) noexcept {
  if (is_listed_pseudo_terminal(path)) {
    constexpr char kTarget[] = "../../devices/virtual/tty/pts";
    const std::size_t length = std::min(sizeof kTarget - 1, capacity);
    std::memcpy(into, kTarget, length);
    return static_cast<ssize_t>(length);
  }
  return readlinkat(AT_FDCWD, path, into, capacity);
}

extern "C" int ioctl(int file, unsigned long request, ...) noexcept {
  std::va_list arguments;
  va_start(arguments, request);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  const long result = syscall(SYS_ioctl, file, request, argument);
  if (result < 0 && errno == ENOTTY && is_modem_request(request)) {
    if (request == TIOCMGET) *static_cast<int*>(argument) = 0;
    return 0;
  }
  return static_cast<int>(result);
}

namespace pellucida {

PseudoTerminal::PseudoTerminal() {
  char name[128];
  int near = -1;
  if (openpty(&master_, &near, name, nullptr, nullptr) != 0) throw std::runtime_error("no pseudo-terminal to be had");
  path_ = name;
  termios raw{};
  tcgetattr(near, &raw);
  cfmakeraw(&raw);
  tcsetattr(near, TCSANOW, &raw);
  close(near);
}

PseudoTerminal::~PseudoTerminal() {
  unplug();
}

void PseudoTerminal::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(master_, bytes.data(), bytes.size());
    if (count <= 0) throw std::runtime_error("the pseudo-terminal does not take bytes");
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void PseudoTerminal::serve(std::function<std::string(const std::string&)> answer) {
  answer_ = std::move(answer);
  thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

void PseudoTerminal::run(std::stop_token stop) {
  std::string line;
  while (!stop.stop_requested()) {
    pollfd waiting{master_, POLLIN, 0};
    if (poll(&waiting, 1, 5) <= 0) continue;
    char bytes[256];
    // Nobody at the near end reads as an error: it may come back.
    const ssize_t count = read(master_, bytes, sizeof bytes);
    if (count <= 0) {
      usleep(1000);
      continue;
    }
    for (const char byte : std::string_view(bytes, static_cast<std::size_t>(count))) {
      if (byte != '\r') {
        line += byte;
        continue;
      }
      const std::string back = answer_(line);
      line.clear();
      if (!back.empty()) send(back);
    }
  }
}

void PseudoTerminal::unplug() {
  if (thread_.joinable()) {
    thread_.request_stop();
    if (thread_.get_id() != std::this_thread::get_id()) thread_.join();
  }
  if (master_ >= 0) close(master_);
  master_ = -1;
}

}  // namespace pellucida
