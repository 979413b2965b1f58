#include "BackgroundTask.h"

#include <QMetaObject>
#include <utility>

#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

// Ends a piece of work that was cancelled; its result is dropped.
struct WorkCancelled {};

}  // namespace

bool BackgroundTask::Control::go_on(std::size_t done, std::size_t all) const {
  task_->post(run_, [task = task_, done, all] {
    if (task->progress_) task->progress_(done, all);
  });
  return !stop_.stop_requested();
}

void BackgroundTask::Control::progress(std::size_t done, std::size_t all) const {
  if (!go_on(done, all)) throw WorkCancelled{};
}

BackgroundTask::~BackgroundTask() {
  cancel();
}

void BackgroundTask::run(Work work, Progress progress, Failed failed) {
  cancel();
  progress_ = std::move(progress);
  running_ = true;
  const std::size_t run = run_;
  thread_ = std::jthread([this, run, work = std::move(work), failed = std::move(failed)](std::stop_token stop) {
    Control control;
    control.task_ = this;
    control.run_ = run;
    control.stop_ = stop;
    std::function<void()> outcome;
    try {
      outcome = work(control);
    } catch (const WorkCancelled&) {
      outcome = [] {};
    } catch (const std::exception& error) {
      outcome = [failed, text = say_message(error.what())] { failed(text); };
    }
    post(run, [this, outcome = std::move(outcome)] {
      running_ = false;
      outcome();
    });
  });
}

void BackgroundTask::cancel() {
  ++run_;
  running_ = false;
  ask_to_end();
  if (thread_.joinable()) thread_.join();
}

void BackgroundTask::ask_to_end() {
  thread_.request_stop();
}

void BackgroundTask::post(std::size_t run, std::function<void()> action) {
  QMetaObject::invokeMethod(
      this,
      [this, run, action = std::move(action)] {
        if (run == run_) action();
      },
      Qt::QueuedConnection);
}

}  // namespace pellucida
