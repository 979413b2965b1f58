#include "pellucida/session/SessionSource.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>
#include <vector>

#include "SessionFolder.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core_vtk/DamageCounter.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/vtk_files/DataFile.h"

namespace pellucida {
namespace {

/// A row's time has 9 significant digits, a file's stamp all of them.
constexpr double kPlayedRowDigits_ratio = 1e-8;
/// Spacing is written as text with 15 digits at most: nearer than this it is the session's own pixel size.
constexpr double kSpacingDigits_ratio = 1e-9;

void require_playable(const PlaybackOptions& options) {
  if (options.every < 1) throw UsageError("--every " + std::to_string(options.every) + ": give 1 or more");
  if (options.loop_count < 0) {
    throw UsageError("--loop " + std::to_string(options.loop_count) + ": give 1 or more, or 0 for no end");
  }
  const auto& pixel_um = options.pixel_size_um;
  if (pixel_um && !(*pixel_um >= 0.001 && *pixel_um <= 100.0)) {
    throw UsageError("--pixel-size-um " + csv_number(*pixel_um) + ": give 0.001 to 100 um");
  }
}

/// The median of the differences between rows, where the head does not say.
double frame_rate_of(const SessionReader& session) {
  std::vector<double> periods_s;
  const auto& steps = session.steps();
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const auto frame_count = static_cast<double>(steps[i].frame_index - steps[i - 1].frame_index);
    if (frame_count > 0.0) periods_s.push_back((steps[i].time_s - steps[i - 1].time_s) / frame_count);
  }
  if (periods_s.empty()) return 1.0;
  const auto middle = periods_s.begin() + static_cast<std::ptrdiff_t>(periods_s.size() / 2);
  std::nth_element(periods_s.begin(), middle, periods_s.end());
  return *middle > 0.0 ? 1.0 / *middle : 1.0;
}

}  // namespace

bool is_session(const std::filesystem::path& folder) noexcept {
  std::error_code ignored;
  return std::filesystem::is_regular_file(folder / session_name::kJson, ignored);
}

FrameUse recorded_use(const SessionReader& session, const std::optional<FramesUsed>& used, std::size_t step) {
  const SessionStep& one = session.steps()[step];
  if (!session.measurements()[step].state) return FrameUse::kKeep;
  // After a crash the head is a second behind the rows.
  const auto is_stated = [&] {
    const auto& stretches = used->tracked.stretches();
    return !stretches.empty() && one.frame_index <= stretches.back().second;
  };
  if (!used || !is_stated() || used->measured.holds(one.frame_index)) return FrameUse::kMeasure;
  return one.has(SessionPart::kSurface) ? FrameUse::kRevolve : FrameUse::kTrack;
}

std::vector<std::size_t> chosen_steps(const SessionReader& session, const PlaybackOptions& options) {
  require_playable(options);
  const auto& steps = session.steps();
  const std::string name = session.folder().string();
  if (steps.empty()) throw InputError(name + ": a session without a frame; nothing to replay");
  std::vector<std::size_t> chosen;
  std::size_t within = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (options.from_s && steps[i].time_s < *options.from_s) continue;
    if (options.to_s && steps[i].time_s > *options.to_s) continue;
    if (within++ % static_cast<std::size_t>(options.every) == 0) chosen.push_back(i);
  }
  if (chosen.empty()) {
    throw UsageError(name + ": no frame between --from and --to; the session lasts from " +
                     csv_number(steps.front().time_s) + " to " + csv_number(steps.back().time_s) + " s");
  }
  if (options.backwards) std::reverse(chosen.begin(), chosen.end());
  return chosen;
}

class SessionSource::Impl {
 public:
  Impl(const std::filesystem::path& folder, const PlaybackOptions& options)
      : reader_(folder),
        options_(options),
        used_(frames_used_of(reader_.info())),
        chosen_(chosen_steps(reader_, options)) {
    require_images();
    describe();
    find_damage();
  }

  std::optional<Frame> next() {
    while (position_ < chosen_.size() || begin_pass()) {
      const std::size_t step = chosen_[position_++];
      if (auto image = read(step)) return frame_of(step, std::move(image));
    }
    return std::nullopt;
  }

  void restart() {
    damage_ = {};
    position_ = 0;
    pass_ = 0;
    last_step_.reset();
  }

  const SessionReader reader_;
  const PlaybackOptions options_;
  const std::optional<FramesUsed> used_;
  const std::vector<std::size_t> chosen_;  // steps of one pass, in their order
  SourceInfo info_;
  long absent_count_ = 0;
  long damaged_count_ = 0;
  std::string first_damage_;

 private:
  void require_images() const {
    const auto& steps = reader_.steps();
    const auto has_image = [](const SessionStep& step) { return step.has(SessionPart::kFrame); };
    if (std::any_of(steps.begin(), steps.end(), has_image)) return;
    throw InputError(reader_.folder().string() +
                     ": recorded without images, so nothing can be tracked; what was tracked can be measured again " +
                     "with pellucida replay --rerun mechanics");
  }

  void describe() {
    const SourceInfo& recorded = reader_.info().source;
    info_ = recorded;
    info_.name = reader_.folder().string();
    info_.live = false;
    info_.pixel_size_origin = "session";
    info_.frame_rate_origin = "session";
    if (options_.pixel_size_um) {
      info_.pixel_size_um = *options_.pixel_size_um;
      info_.pixel_size_origin = "option";
    }
    if (!(info_.pixel_size_um > 0.0)) {
      throw InputError(info_.name + ": its session.json has no pixel size; give --pixel-size-um");
    }
    if (!(info_.frame_rate_hz > 0.0)) info_.frame_rate_hz = frame_rate_of(reader_);
    const auto image_count = std::count_if(chosen_.begin(), chosen_.end(), [&](std::size_t step) {
      return reader_.steps()[step].has(SessionPart::kFrame);
    });
    info_.frame_count.reset();
    if (options_.loop_count > 0) info_.frame_count = static_cast<long>(image_count) * options_.loop_count;
    if (info_.width_px > 0 && info_.height_px > 0) return;
    // A head that was rebuilt does not know the size.
    for (const std::size_t step : chosen_) {
      const auto image = read(step);
      if (!image) continue;
      info_.width_px = image->GetDimensions()[0];
      info_.height_px = image->GetDimensions()[1];
      info_.bit_depth = image->GetScalarType() == VTK_UNSIGNED_SHORT ? 16 : 8;
      break;
    }
    absent_count_ = 0;
    damaged_count_ = 0;
  }

  bool begin_pass() {
    // A pass without a single readable image is the last, or there would be no end.
    if (!last_step_ || (options_.loop_count > 0 && pass_ + 1 >= options_.loop_count)) return false;
    ++pass_;
    position_ = 0;
    last_step_.reset();
    return true;
  }

  // The image of a step; null, and counted, when there is none that can be read.
  vtkSmartPointer<vtkImageData> read(std::size_t index) {
    const SessionStep& step = reader_.steps()[index];
    if (!step.has(SessionPart::kFrame)) {
      ++absent_count_;
      return nullptr;
    }
    try {
      auto image = reader_.read_image(index);
      require_usable(image, step);
      return image;
    } catch (const InputError& error) {
      if (damaged_count_++ == 0) first_damage_ = error.what();
      return nullptr;
    }
  }

  // The reader holds an image against head, name and checksum. A head that was rebuilt knows no size, and none a row.
  void require_usable(vtkImageData* image, const SessionStep& step) const {
    const auto refuse = [&](const char* reason) {
      throw InputError((reader_.folder() / part_file(SessionPart::kFrame, step.frame_index)).string() + reason);
    };
    const int* size = image->GetDimensions();
    if (info_.width_px > 0 && (size[0] != info_.width_px || size[1] != info_.height_px)) {
      refuse(": not of the other images' size");
    }
    const double tolerance_s = kPlayedRowDigits_ratio * (1.0 + std::abs(step.time_s));
    if (!(std::abs(stamped_time_s(image) - step.time_s) <= tolerance_s)) {
      refuse(": stamped with another time than its row's; run pellucida check on the session");
    }
  }

  Frame frame_of(std::size_t index, vtkSmartPointer<vtkImageData> image) {
    const SessionStep& step = reader_.steps()[index];
    Frame frame;
    frame.time_s = stamped_time_s(image);
    frame.frame_index = step.frame_index;
    frame.gap_count = gap_before(index);
    const Measurement& row = reader_.measurements()[index];
    const Eigen::Vector2d manipulator_um(row.manipulator_x_um, row.manipulator_y_um);
    if (manipulator_um.allFinite()) frame.manipulator_um = manipulator_um;
    frame.use = options_.all_frames || options_.backwards ? FrameUse::kMeasure : recorded_use(reader_, used_, index);
    frame.run_index = recorded_runs_before(step.frame_index) + static_cast<long>(pass_) * runs_in_pass();
    const auto stretch = std::find_if(damaged_stretches_.begin(), damaged_stretches_.end(), [&](const auto& one) {
      return step.time_s >= one.first && step.time_s < one.second;
    });
    frame.damage = damage_.add(stretch != damaged_stretches_.end(), "in the recording of this session");
    last_step_ = index;
    if (options_.backwards || pass_ > 0) {
      number_on(frame);
      stamp(image, frame.time_s, frame.frame_index);
    }
    const double spacing_um = image->GetSpacing()[0];
    if (options_.pixel_size_um ||
        std::abs(spacing_um - info_.pixel_size_um) <= kSpacingDigits_ratio * info_.pixel_size_um) {
      image->SetSpacing(info_.pixel_size_um, info_.pixel_size_um, 1.0);
    }
    frame.image = Frozen<vtkImageData>(std::move(image));
    return frame;
  }

  // What was recorded from a damaged source stays so.
  void find_damage() {
    for (const Event& event : reader_.events()) {
      if (event.kind != event_kind::kDamaged) continue;
      if (!event.detail.starts_with("over")) {
        damaged_stretches_.emplace_back(event.time_s, std::numeric_limits<double>::infinity());
      } else if (!damaged_stretches_.empty()) {
        damaged_stretches_.back().second = event.time_s;
      }
    }
  }

  // Mirrored within its pass, and moved to its place in the order of passes.
  void number_on(Frame& frame) const {
    const auto [early, late] = std::minmax(chosen_.front(), chosen_.back());
    const SessionStep& first = reader_.steps()[early];
    const SessionStep& last = reader_.steps()[late];
    if (options_.backwards) {
      frame.time_s = first.time_s + (last.time_s - frame.time_s);
      frame.frame_index = first.frame_index + (last.frame_index - frame.frame_index);
    }
    frame.time_s += pass_ * (last.time_s - first.time_s + options_.every / info_.frame_rate_hz);
    frame.frame_index += pass_ * (last.frame_index - first.frame_index + 1);
  }

  // Frames between this one and the one delivered before it that nobody left out on purpose.
  long gap_before(std::size_t index) const {
    if (!last_step_) return 0;
    const auto [early, late] = std::minmax(*last_step_, index);
    const auto& steps = reader_.steps();
    long missing = steps[late].frame_index - steps[early].frame_index - 1;
    for (std::size_t i = early + 1; i < late; ++i) missing -= steps[i].has(SessionPart::kFrame) ? 1 : 0;
    return std::max(0L, missing);
  }

  long recorded_runs_before(long frame_index) const {
    if (!used_ || options_.backwards) return 0;
    return std::upper_bound(used_->run_starts.begin(), used_->run_starts.end(), frame_index) -
           used_->run_starts.begin();
  }
  long runs_in_pass() const { return used_ ? static_cast<long>(used_->run_starts.size()) + 1 : 1; }

  std::size_t position_ = 0;
  int pass_ = 0;
  std::optional<std::size_t> last_step_;
  std::vector<std::pair<double, double>> damaged_stretches_;  // times: from, and to without it
  DamageCounter damage_;
};

SessionSource::SessionSource(const std::filesystem::path& folder, const PlaybackOptions& options)
    : impl_(std::make_unique<Impl>(folder, options)) {}
SessionSource::~SessionSource() = default;

const SourceInfo& SessionSource::info() const noexcept {
  return impl_->info_;
}
std::optional<Frame> SessionSource::next() {
  return impl_->next();
}
bool SessionSource::restart() {
  impl_->restart();
  return true;
}
const SessionReader& SessionSource::session() const noexcept {
  return impl_->reader_;
}
long SessionSource::chosen_count() const noexcept {
  return static_cast<long>(impl_->chosen_.size());
}
long SessionSource::absent_count() const noexcept {
  return impl_->absent_count_;
}
long SessionSource::damaged_count() const noexcept {
  return impl_->damaged_count_;
}
const std::string& SessionSource::first_damage() const noexcept {
  return impl_->first_damage_;
}

}  // namespace pellucida
