#pragma once
#include <pthread.h>

#include <string>

namespace pellucida {

/// Behaviour if the system does not grant what a 1 kHz thread needs.
enum class RealTimePolicy {
  kIgnore,  ///< run without, and report it
  kEnforce  ///< don't start
};

/// What the system granted, and why not.
struct RealTimeOutcome {
  bool fifo = false;
  int fifo_priority = 0;
  bool memory_locked = false;
  std::string refused;  ///< empty when all was granted; otherwise what, why and how to allow it

  /// One line: "SCHED_FIFO 80, memory locked", or what is missing.
  std::string text() const;
};

/// Gives the thread first-in-first-out real-time priority (1..99). Any thread may call it. Fills the outcome.
void raise_priority(pthread_t thread, int priority, RealTimeOutcome& outcome);

/// Keeps the process' memory from being paged out, what it has and what it will get, as far as it is touched. Refused
/// where the system limits locked memory: then every later allocation could fail.
void lock_memory(RealTimeOutcome& outcome);

/// While it exists, the processors do not enter sleep states that take long to wake from (Linux's power management
/// quality of service), where the system allows: waking from it is most of a timer's lateness on an idle machine.
class QuickWakeRequest {
 public:
  QuickWakeRequest() noexcept;
  ~QuickWakeRequest();
  QuickWakeRequest(const QuickWakeRequest&) = delete;
  QuickWakeRequest& operator=(const QuickWakeRequest&) = delete;

  bool granted() const noexcept { return file_ >= 0; }

 private:
  int file_;
};

/// For the calling thread: its timers fire when due instead of up to 50 us later, which is what the system grants
/// itself for a thread of normal priority.
void sharpen_timers() noexcept;

/// Touches the calling thread's stack, so that no page fault occurs in a tick.
void prefault_stack() noexcept;

}  // namespace pellucida
