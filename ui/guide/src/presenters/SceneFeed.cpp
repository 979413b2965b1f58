#include "presenters/SceneFeed.h"

namespace pellucida {

SceneFeed::SceneFeed(const LiveRun& run, StageSource* source) : run_(run), source_(source) {
  source_->SetExchange(run_.scenes());
}

bool SceneFeed::poll() {
  new_rows_.clear();
  if (source_->Poll()) {
    is_measured_ = true;
    // The chain goes on meanwhile: later rows wait for their scene.
    for (const Measurement& row : run_.measurements_since(row_count_)) {
      if (row.frame > source_->GetScene().measurement.frame) break;
      new_rows_.push_back(row);
    }
    row_count_ += new_rows_.size();
    return true;
  }
  if (is_measured_) return false;
  const auto frame = run_.frames()->peek();
  if (!frame || frame->measurement.frame == frame_) return false;
  frame_ = frame->measurement.frame;
  source_->SetScene(*frame);
  return true;
}

const Scene* SceneFeed::measured() const {
  return is_measured_ ? &source_->GetScene() : nullptr;
}

}  // namespace pellucida
