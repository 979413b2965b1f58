#include "commands/Interrupt.h"

#include <signal.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <initializer_list>

namespace pellucida {
namespace {

std::atomic<int> scope_count{0};
std::atomic<int> kept_signal{0};
std::atomic<int> wake_descriptor{-1};
static_assert(std::atomic<int>::is_always_lock_free);

// Only what a signal handler may call.
void say(const char* before, const char* name, const char* behind) noexcept {
  for (const char* text : {before, name, behind}) {
    [[maybe_unused]] const ssize_t result = ::write(STDERR_FILENO, text, std::strlen(text));
  }
}

[[noreturn]] void end_by(int number) noexcept {
  ::signal(number, SIG_DFL);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, number);
  ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
  ::raise(number);
  ::_exit(128 + number);
}

void on_signal(int number) {
  int none = 0;
  if (scope_count.load() > 0 && kept_signal.compare_exchange_strong(none, number)) {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t result = ::write(wake_descriptor.load(), &one, sizeof one);
    say("\npellucida: ", signal_name(number), ": completing what is done; a second one ends at once\n");
    return;
  }
  say("\npellucida: ended by ", signal_name(number), "\n");
  end_by(number);
}

}  // namespace

void install_signals() {
  ::signal(SIGXFSZ, SIG_IGN);
  wake_descriptor = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    ::sigaction(number, &action, nullptr);
  }
}

InterruptScope::InterruptScope() noexcept {
  ++scope_count;
}

InterruptScope::~InterruptScope() {
  --scope_count;
}

int interrupted() noexcept {
  return kept_signal.load();
}

int interrupt_descriptor() noexcept {
  return wake_descriptor.load();
}

const char* signal_name(int number) noexcept {
  return number == SIGINT ? "SIGINT" : number == SIGTERM ? "SIGTERM" : number == SIGHUP ? "SIGHUP" : "a signal";
}

void end_if_interrupted() {
  if (const int number = interrupted(); number != 0) end_by(number);
}

}  // namespace pellucida
