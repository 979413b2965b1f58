#include "pellucida/session/SessionReader.h"

#include <algorithm>
#include <stdexcept>

#include "DataFile.h"
#include "SessionFolder.h"
#include "SessionIndex.h"
#include "SessionJson.h"
#include "pellucida/core/Error.h"

namespace pellucida {

class SessionReader::Impl {
 public:
  explicit Impl(const std::filesystem::path& folder) : folder_(folder) {
    if (!std::filesystem::is_directory(folder_))
      throw InputError(folder_.string() + ": no such session folder; check the path");
    if (!std::filesystem::exists(folder_ / session_name::kJson)) {
      throw InputError(folder_.string() + ": no session here (session.json is missing); name a session's folder");
    }
    head_ = read_session_json(folder_ / session_name::kJson);
    auto measurements = read_measurements(folder_ / session_name::kMeasurements);
    if (!measurements.present) {
      throw InputError(folder_.string() + ": measurements.csv is missing; the session can't be read without it");
    }
    measurements_ = std::move(measurements.rows);
    events_ = read_events(folder_ / session_name::kEvents).rows;
    SessionFiles files = list_files(folder_);
    steps_ = make_steps(measurements_, files);
    hand_blocks_ = std::move(files.hand_blocks);
  }

  Scene load(std::size_t index) const {
    const SessionStep& step = step_at(index);
    Scene scene;
    scene.arrival_s = step.time_s;
    scene.measurement = measurements_[index];
    scene.surface = read_part(step, SessionPart::kSurface);
    scene.membranes = read_part(step, SessionPart::kMembranes);
    scene.tools = read_part(step, SessionPart::kTools);
    if (step.has(SessionPart::kFrame)) {
      scene.frame = Frozen(read_image_file(folder_ / part_file(SessionPart::kFrame, step.frame_index)));
    }
    // Events belong to the step they came with: from its time up to the next one's.
    const bool last = index + 1 == steps_.size();
    std::copy_if(events_.begin(), events_.end(), std::back_inserter(scene.events), [&](const Event& event) {
      return event.time_s >= step.time_s && (last || event.time_s < steps_[index + 1].time_s);
    });
    return scene;
  }

  const SessionStep& step_at(std::size_t index) const {
    if (index < steps_.size()) return steps_[index];
    throw std::out_of_range("step " + std::to_string(index) + " of a session of " + std::to_string(steps_.size()));
  }

  Frozen<vtkPolyData> read_part(const SessionStep& step, SessionPart part) const {
    if (!step.has(part)) return {};
    return Frozen(read_poly_file(folder_ / part_file(part, step.frame_index)));
  }

  std::filesystem::path folder_;
  SessionHead head_;
  std::vector<Measurement> measurements_;
  std::vector<Event> events_;
  std::vector<SessionStep> steps_;
  std::vector<long> hand_blocks_;
};

SessionReader::SessionReader(const std::filesystem::path& folder) : impl_(std::make_unique<Impl>(folder)) {}
SessionReader::~SessionReader() = default;
SessionReader::SessionReader(SessionReader&&) noexcept = default;
SessionReader& SessionReader::operator=(SessionReader&&) noexcept = default;

const std::filesystem::path& SessionReader::folder() const noexcept {
  return impl_->folder_;
}
const SessionInfo& SessionReader::info() const noexcept {
  return impl_->head_.info;
}
bool SessionReader::complete() const noexcept {
  return impl_->head_.complete;
}
const SessionCounts& SessionReader::stated_counts() const noexcept {
  return impl_->head_.counts;
}
const std::vector<SessionStep>& SessionReader::steps() const noexcept {
  return impl_->steps_;
}
const std::vector<Measurement>& SessionReader::measurements() const noexcept {
  return impl_->measurements_;
}
const std::vector<Event>& SessionReader::events() const noexcept {
  return impl_->events_;
}
std::size_t SessionReader::hand_block_count() const noexcept {
  return impl_->hand_blocks_.size();
}
Frozen<vtkPolyData> SessionReader::load_hand(std::size_t block) const {
  return Frozen(read_poly_file(impl_->folder_ / hand_file(impl_->hand_blocks_.at(block))));
}
Scene SessionReader::load(std::size_t step) const {
  return impl_->load(step);
}

Frozen<vtkPolyData> SessionReader::load(std::size_t step, SessionPart part) const {
  if (part == SessionPart::kFrame) throw std::invalid_argument("an image is no surface, membrane or tool");
  return impl_->read_part(impl_->step_at(step), part);
}

}  // namespace pellucida
