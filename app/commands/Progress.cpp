#include "commands/Progress.h"

#include <unistd.h>

#include <cstdio>

namespace pellucida {

Progress::Progress(std::string what) : what_(std::move(what)), on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (on_terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::update(long done, std::optional<long> all) {
  const auto now = std::chrono::steady_clock::now();
  if (!on_terminal_ || now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  if (all) {
    std::fprintf(stderr, "\r\033[K%s %ld / %ld", what_.c_str(), done, *all);
  } else {
    std::fprintf(stderr, "\r\033[K%s %ld", what_.c_str(), done);
  }
  std::fflush(stderr);
}

}  // namespace pellucida
