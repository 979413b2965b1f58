#pragma once
#include <QObject>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>

namespace pellucida {

/// One piece of work at a time on a thread of its own, for the window's thread: progress, result and failure arrive
/// there, as events, never after `cancel`, another `run` or the task's end. All calls on the window's thread.
class BackgroundTask : public QObject {
 public:
  /// Handed to the work.
  class Control {
   public:
    /// Reports (done, all); throws when the work was cancelled, so that it ends at its next report.
    void progress(std::size_t done, std::size_t all) const;
    /// Reports likewise; false when the work was cancelled.
    bool go_on(std::size_t done, std::size_t all) const;

   private:
    friend class BackgroundTask;
    BackgroundTask* task_ = nullptr;
    std::size_t run_ = 0;
    std::stop_token stop_;
  };
  /// Done on the task's thread; what it returns is called on the window's thread.
  using Work = std::function<std::function<void()>(const Control&)>;
  using Progress = std::function<void(std::size_t, std::size_t)>;
  using Failed = std::function<void(const std::string&)>;

  explicit BackgroundTask(QObject* parent = nullptr) : QObject(parent) {}
  ~BackgroundTask() override;

  /// Ends what runs and begins. `failed`: with the error's text.
  void run(Work work, Progress progress, Failed failed);
  /// Asks the work to end and waits for it; nothing of it arrives any more.
  void cancel();
  /// Asks the work to end at its next report, which still brings its result, if it has one then.
  void ask_to_end();
  bool running() const noexcept { return running_; }

 private:
  void post(std::size_t run, std::function<void()> action);

  std::jthread thread_;
  std::size_t run_ = 0;  // number of the present work: what an earlier one posted is dropped
  bool running_ = false;
  Progress progress_;
};

}  // namespace pellucida
