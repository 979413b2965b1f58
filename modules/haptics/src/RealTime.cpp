#include "pellucida/haptics/RealTime.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace pellucida {
namespace {

void add(std::string& text, const std::string& more) {
  text += (text.empty() ? "" : "; ") + more;
}

}  // namespace

std::string RealTimeOutcome::text() const {
  std::string text = fifo ? "SCHED_FIFO " + std::to_string(fifo_priority) : "normal scheduling";
  text += memory_locked ? ", memory locked" : ", memory not locked";
  return refused.empty() ? text : text + " (" + refused + ")";
}

void raise_priority(pthread_t thread, int priority, RealTimeOutcome& outcome) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int error = pthread_setschedparam(thread, SCHED_FIFO, &parameters);
  outcome.fifo = error == 0;
  outcome.fifo_priority = outcome.fifo ? priority : 0;
  if (error != 0) {
    add(outcome.refused, std::string("SCHED_FIFO: ") + std::strerror(error) +
                             "; allow it with the line \"@users - rtprio 95\" in /etc/security/limits.conf");
  }
}

void lock_memory(RealTimeOutcome& outcome) {
  // Who has the right to more, takes it.
  const rlimit wished{RLIM_INFINITY, RLIM_INFINITY};
  setrlimit(RLIMIT_MEMLOCK, &wished);
  rlimit limit{};
  const bool unlimited = getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
  // Locking what is still to come, under a limit, would let every later allocation of the process fail at that limit.
  const int future = unlimited ? MCL_FUTURE : 0;
  if (mlockall(MCL_CURRENT | MCL_ONFAULT | future) == 0) {
    outcome.memory_locked = true;
    return;
  }
  add(outcome.refused, std::string("memory: ") + std::strerror(errno) + ", limited to " +
                           std::to_string(limit.rlim_cur / 1024) +
                           " kB; allow it with the line \"@users - memlock unlimited\" in /etc/security/limits.conf");
}

// The request counts as long as the file is open.
QuickWakeRequest::QuickWakeRequest() noexcept : file_(open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC)) {
  constexpr std::int32_t kLongest_us = 0;
  if (file_ >= 0 && write(file_, &kLongest_us, sizeof kLongest_us) != sizeof kLongest_us) {
    close(file_);
    file_ = -1;
  }
}

QuickWakeRequest::~QuickWakeRequest() {
  if (file_ >= 0) close(file_);
}

void sharpen_timers() noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
}

void prefault_stack() noexcept {
  constexpr std::size_t kStackBytes = 128 * 1024, kPage = 4096;
  volatile char stack[kStackBytes];
  char read = 0;
  for (std::size_t k = 0; k < kStackBytes; k += kPage) {
    stack[k] = read;
    read = stack[k];
  }
}

}  // namespace pellucida
