#include "pellucida/session/SessionReader.h"

#include <algorithm>
#include <stdexcept>

#include "DiskFile.h"
#include "PartReader.h"
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
    if (!is_present(folder_ / session_name::kJson)) {
      throw InputError(folder_.string() + ": no session here (session.json is missing); name a session's folder");
    }
    head_ = read_session_json(folder_ / session_name::kJson);
    checksums_ = read_checksums(folder_ / session_name::kChecksums);
    checksums_.forget_text();
    auto measurements = read_measurements(folder_ / session_name::kMeasurements, checksums_.present);
    if (!measurements.present) {
      throw InputError(folder_.string() + ": measurements.csv is missing; the session can't be read without it");
    }
    measurements_ = std::move(measurements.rows);
    auto events = read_events(folder_ / session_name::kEvents, checksums_.present);
    events_ = std::move(events.rows);
    skipped_row_count_ = measurements.bad.size() + events.bad.size();
    SessionFiles files = list_files(folder_);
    steps_ = make_steps(measurements_, files);
    hand_blocks_ = std::move(files.hand_blocks);
    parts_ = std::make_unique<PartReader>(folder_, checksums_, head_.info.source);
  }

  Scene load(std::size_t index) const {
    const SessionStep& step = step_at(index);
    Scene scene;
    scene.arrival_s = step.time_s;
    scene.measurement = measurements_[index];
    scene.surface = read_part(step, SessionPart::kSurface);
    scene.membranes = read_part(step, SessionPart::kMembranes);
    scene.tools = read_part(step, SessionPart::kTools);
    if (auto image = read_image(step)) scene.frame = Frozen(std::move(image));
    // Events belong to the step they came with: from its time up to the next one's.
    const bool last = index + 1 == steps_.size();
    const auto first_from = [&](double time_s) {
      return std::lower_bound(events_.begin(), events_.end(), time_s,
                              [](const Event& event, double from_s) { return event.time_s < from_s; });
    };
    const auto begin = first_from(step.time_s);
    const auto end = last ? events_.end() : first_from(steps_[index + 1].time_s);
    if (begin < end) scene.events.assign(begin, end);
    return scene;
  }

  const SessionStep& step_at(std::size_t index) const {
    if (index < steps_.size()) return steps_[index];
    throw std::out_of_range("step " + std::to_string(index) + " of a session of " + std::to_string(steps_.size()));
  }

  vtkSmartPointer<vtkImageData> read_image(const SessionStep& step) const {
    return step.has(SessionPart::kFrame) ? parts_->read_image(step.frame_index) : nullptr;
  }

  Frozen<vtkPolyData> read_part(const SessionStep& step, SessionPart part) const {
    if (!step.has(part)) return {};
    return Frozen(parts_->read_poly(data_name(part, step.frame_index)));
  }

  std::filesystem::path folder_;
  SessionHead head_;
  std::vector<Measurement> measurements_;
  std::vector<Event> events_;
  std::vector<SessionStep> steps_;
  std::vector<long> hand_blocks_;
  SessionTable<FileChecksum> checksums_;
  std::unique_ptr<PartReader> parts_;
  std::size_t skipped_row_count_ = 0;
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
const std::string& SessionReader::created() const noexcept {
  return impl_->head_.created;
}
bool SessionReader::complete() const noexcept {
  return impl_->head_.complete;
}
const SessionCounts& SessionReader::stated_counts() const noexcept {
  return impl_->head_.counts;
}
bool SessionReader::head_changed() const noexcept {
  return impl_->head_.changed;
}
std::size_t SessionReader::skipped_row_count() const noexcept {
  return impl_->skipped_row_count_;
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
  return Frozen(impl_->parts_->read_poly({kHandKind, impl_->hand_blocks_.at(block)}));
}
Scene SessionReader::load(std::size_t step) const {
  return impl_->load(step);
}

Frozen<vtkPolyData> SessionReader::load(std::size_t step, SessionPart part) const {
  if (part == SessionPart::kFrame) throw std::invalid_argument("an image is no surface, membrane or tool");
  return impl_->read_part(impl_->step_at(step), part);
}

vtkSmartPointer<vtkImageData> SessionReader::read_image(std::size_t step) const {
  return impl_->read_image(impl_->step_at(step));
}

}  // namespace pellucida
