#pragma once
#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "pellucida/core/Clock.h"
#include "pellucida/core/Step.h"

namespace pellucida {

/// The work of a stage so far.
struct StageCounts {
  std::uint64_t done_count = 0;    ///< items turned into an output
  std::uint64_t failed_count = 0;  ///< items for which the step had no output
  double last_step_s = 0.0;        ///< how long the newest item took
  double total_step_s = 0.0;       ///< all items together
  std::string last_failure;        ///< reason of the newest failure
};

/// Gives any step a thread: takes items from `In` (SharedLatest: newest wins; Ring: all in order), runs the step,
/// passes each output to `sink`. Stops on request, or when the input is closed and empty. An exception of the step ends
/// the stage and is kept for `rethrow`. Step, input and clock must outlive the stage.
template <Step S, class In>
class Stage {
 public:
  using Sink = std::function<void(typename S::Output)>;
  using FailureSink = std::function<void(const typename S::Input&, const StepFailure&)>;

  /// `failed` (may be empty) receives the items for which the step has no output. Both sinks are called on the stage's
  /// thread.
  Stage(S& step, In& input, Sink sink, const Clock& clock, FailureSink failed = {})
      : step_(step), input_(input), sink_(std::move(sink)), failed_(std::move(failed)), clock_(clock) {}
  ~Stage() { stop(); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void start() {
    thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
  }

  /// Requests the thread to end and waits for it; items still waiting in the input remain there.
  void stop() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
  }

  /// Waits until the input is closed and all of it has been processed.
  void join() {
    if (thread_.joinable()) thread_.join();
  }

  bool running() const noexcept { return running_.load(std::memory_order_acquire); }

  StageCounts counts() const {
    std::lock_guard lock(mutex_);
    return counts_;
  }

  /// Throws what the step threw, if it did.
  void rethrow() const {
    std::lock_guard lock(mutex_);
    if (fault_) std::rethrow_exception(fault_);
  }

 private:
  void run(std::stop_token stop) {
    running_.store(true, std::memory_order_release);
    try {
      while (auto item = input_.wait(stop)) process(*item);
    } catch (...) {
      {
        std::lock_guard lock(mutex_);
        fault_ = std::current_exception();
      }
      input_.close();
    }
    running_.store(false, std::memory_order_release);
  }

  void process(const typename S::Input& item) {
    const double start_s = clock_.now_s();
    auto output = step_.process(item);
    const double step_s = clock_.now_s() - start_s;
    {
      std::lock_guard lock(mutex_);
      counts_.last_step_s = step_s;
      counts_.total_step_s += step_s;
      if (output) {
        ++counts_.done_count;
      } else {
        ++counts_.failed_count;
        counts_.last_failure = output.error().reason;
      }
    }
    if (output) {
      sink_(std::move(*output));
    } else if (failed_) {
      failed_(item, output.error());
    }
  }

  S& step_;
  In& input_;
  Sink sink_;
  FailureSink failed_;
  const Clock& clock_;
  mutable std::mutex mutex_;
  StageCounts counts_;
  std::exception_ptr fault_;
  std::atomic<bool> running_{false};
  std::jthread thread_;
};

}  // namespace pellucida
