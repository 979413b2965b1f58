#include "Recorder.h"

#include <algorithm>

#include "Chain.h"

namespace pellucida {

expected<bool, StepFailure> Recorder::WriteStep::process(const Item& item) {
  if (const auto* scene = std::get_if<Scene>(&item)) {
    writer.write(*scene);
    ++written_count;
    return true;
  }
  if (const auto* event = std::get_if<Event>(&item)) writer.event(*event);
  if (const auto* block = std::get_if<HapticPathBlock>(&item)) writer.write_hand(block->paths, block->time_s);
  if (const auto* plan = std::get_if<Plan>(&item)) writer.set_plan(plan->json);
  return false;
}

Recorder::Recorder(const std::filesystem::path& folder, const SessionInfo& info, const Clock& clock)
    : folder_(folder.string()),
      writer_(folder, info),
      stage_(
          step_, queue_, [](bool) {}, clock) {
  stage_.start();
}

Recorder::~Recorder() {
  stage_.stop();
}

void Recorder::announce(const Scene& scene) {
  std::lock_guard lock(mutex_);
  if (!closed_) pending_.push_back({scene, false});
}

void Recorder::settle(const Scene& scene) {
  std::lock_guard lock(mutex_);
  const auto found = std::find_if(pending_.begin(), pending_.end(), [&](const Pending& pending) {
    return pending.scene.measurement.frame == scene.measurement.frame;
  });
  if (found == pending_.end()) return;
  *found = {scene, true};
  flush();
}

void Recorder::event(const Event& event) {
  std::lock_guard lock(mutex_);
  owed_events_.push_back(event);
  flush();
}

bool Recorder::hand(const Frozen<vtkPolyData>& block, double time_s) {
  std::lock_guard lock(mutex_);
  return closed_ || queue_.push(HapticPathBlock{block, time_s});
}

void Recorder::plan(const std::string& plan_json) {
  std::lock_guard lock(mutex_);
  if (!closed_) queue_.push_wait(Plan{plan_json});
}

void Recorder::flush() {
  while (!owed_events_.empty() && queue_.push(owed_events_.front())) owed_events_.pop_front();
  while (!pending_.empty() && pending_.front().settled) {
    const Scene& scene = pending_.front().scene;
    if (!queue_.push(scene)) {
      ++dropped_count_;
      owed_events_.push_back(
          {scene.measurement.time_s, "dropped",
           "frame " + std::to_string(scene.measurement.frame) + " was lost: the disk is slower than the camera"});
    }
    pending_.pop_front();
  }
}

void Recorder::close() {
  {
    std::lock_guard lock(mutex_);
    if (closed_) return;
    closed_ = true;
    for (auto& pending : pending_) {
      if (!pending.settled) pending = {unmeasured(pending.scene), true};
    }
    // From here on there is time: nothing is dropped at the end.
    while (!owed_events_.empty() && queue_.push_wait(owed_events_.front())) owed_events_.pop_front();
    while (!pending_.empty() && queue_.push_wait(pending_.front().scene)) pending_.pop_front();
  }
  queue_.close();
  stage_.join();
  stage_.rethrow();
  writer_.close();
}

std::optional<std::string> Recorder::fault() const {
  try {
    stage_.rethrow();
  } catch (const std::exception& error) {
    return error.what();
  }
  return std::nullopt;
}

}  // namespace pellucida
