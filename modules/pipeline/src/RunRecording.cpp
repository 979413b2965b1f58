#include "RunRecording.h"

#include <utility>

#include "pellucida/core/Error.h"

namespace pellucida {

void RunRecording::start(const std::filesystem::path& folder, SessionInfo info, const Event& started) {
  std::lock_guard control(control_mutex_);
  {
    std::lock_guard lock(mutex_);
    if (recorder_) throw UsageError("a recording is running already; stop it first");
    info.plan_json = plan_json_;
    info.palpation_json = palpation_json_;
  }
  auto recorder = std::make_unique<Recorder>(folder, info, clock_);
  std::lock_guard lock(mutex_);
  if (plan_json_ != info.plan_json) recorder->plan(plan_json_);
  if (palpation_json_ != info.palpation_json) recorder->palpation(palpation_json_);
  for (const Event& note : waiting_notes_) recorder->event(note);
  waiting_notes_.clear();
  recorder->event(started);
  folder_ = folder.string();
  recorder_ = std::move(recorder);
}

void RunRecording::stop(const Event& stopped) {
  std::lock_guard control(control_mutex_);
  std::unique_ptr<Recorder> ended;
  {
    std::lock_guard lock(mutex_);
    ended = std::move(recorder_);
    if (!ended) return;
    recorded_count_ = ended->written_count();
    dropped_count_ = ended->dropped_count();
    thinned_count_ = ended->thinned_count();
  }
  ended->event(stopped);
  std::exception_ptr fault;
  try {
    ended->close();
  } catch (...) {
    fault = std::current_exception();
  }
  {
    std::lock_guard lock(mutex_);
    recorded_count_ = ended->written_count();
    dropped_count_ = ended->dropped_count();
    thinned_count_ = ended->thinned_count();
  }
  if (fault) std::rethrow_exception(fault);
}

void RunRecording::announce(const Scene& scene) {
  std::lock_guard lock(mutex_);
  if (recorder_) recorder_->announce(scene);
}

void RunRecording::settle(const Scene& scene) {
  std::lock_guard lock(mutex_);
  if (recorder_) recorder_->settle(scene);
}

void RunRecording::event(const Event& event) {
  std::lock_guard lock(mutex_);
  if (recorder_) recorder_->event(event);
}

bool RunRecording::hand(const Frozen<vtkPolyData>& block, double time_s) {
  std::lock_guard lock(mutex_);
  return !recorder_ || recorder_->hand(block, time_s);
}

void RunRecording::set_palpation(const std::string& palpation_json) {
  std::lock_guard lock(mutex_);
  palpation_json_ = palpation_json;
  if (recorder_) recorder_->palpation(palpation_json);
}

void RunRecording::set_clocks(const std::string& clocks_json) {
  std::lock_guard lock(mutex_);
  if (recorder_ && !clocks_json.empty()) recorder_->clocks(clocks_json);
}

void RunRecording::set_plan(const std::string& plan_json) {
  std::lock_guard lock(mutex_);
  plan_json_ = plan_json;
  if (recorder_) recorder_->plan(plan_json);
}

bool RunRecording::note(const Event& note) {
  std::lock_guard lock(mutex_);
  if (recorder_ && recorder_->event(note)) return true;
  waiting_notes_.push_back(note);
  return false;
}

RecordingStatus RunRecording::status() const {
  std::lock_guard lock(mutex_);
  RecordingStatus status;
  status.recording = recorder_ != nullptr;
  status.folder = folder_;
  status.recorded_count = recorder_ ? recorder_->written_count() : recorded_count_;
  status.dropped_count = recorder_ ? recorder_->dropped_count() : dropped_count_;
  status.thinned_count = recorder_ ? recorder_->thinned_count() : thinned_count_;
  status.waiting_note_count = waiting_notes_.size();
  if (recorder_) status.fault = recorder_->fault();
  return status;
}

}  // namespace pellucida
