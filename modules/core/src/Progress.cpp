#include "pellucida/core/Progress.h"

#include <unistd.h>

#include <cstdio>

namespace pellucida {

Progress::Progress(std::string what) : what_(std::move(what)), on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (on_terminal_) std::fputs("\r\033[K", stderr);
}

bool Progress::is_due() {
  const auto now = std::chrono::steady_clock::now();
  if (!on_terminal_ || now - last_ < std::chrono::milliseconds(100)) return false;
  last_ = now;
  return true;
}

void Progress::say(const std::string& line) {
  if (!is_due()) return;
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
}

void Progress::note(const std::string& text) {
  std::fprintf(stderr, "%spellucida: %s\n", on_terminal_ ? "\r\033[K" : "", text.c_str());
}

void Progress::update(long done, std::optional<long> all) {
  if (!is_due()) return;
  if (all) {
    std::fprintf(stderr, "\r\033[K%s %ld / %ld", what_.c_str(), done, *all);
  } else {
    std::fprintf(stderr, "\r\033[K%s %ld", what_.c_str(), done);
  }
  std::fflush(stderr);
}

}  // namespace pellucida
