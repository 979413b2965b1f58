#include "pellucida/tracking/MembraneTracker.h"

#include <utility>

#include "CellDetector.h"
#include "CellFollower.h"
#include "ObservationReport.h"
#include "TrackerChecks.h"

namespace pellucida {
namespace {

// A needle with no cell: how far it may go between two frames, and when it counts as gone.
constexpr double kNeedleReach_px = 34.0, kLeastNeedleConfidence = 0.1;

}  // namespace

class MembraneTracker::Impl {
 public:
  explicit Impl(const TrackerOptions& options) : options_(options), cell_(options) {}

  Observation process(const ImageView& view, double time_s, long frame_index, const FrameHints& hints) {
    check(view);
    check(hints);
    timings_ = {};
    FrameInput frame{view, FrameSampler(view), 0.0, {}, &timings_};
    frame.noise = noise_level(frame.image);
    if (hints.needle_motion_um) frame.needle_motion_px = *hints.needle_motion_um / view.pixel_size_um;
    ++frames_since_detection_;
    // Another size is another camera setting: nothing that was followed is where it was.
    if (view.width_px != width_px_ || view.height_px != height_px_) {
      width_px_ = view.width_px;
      height_px_ = view.height_px;
      has_cell_ = false;
      lone_needle_.reset();
      frames_since_detection_ = options_.redetect_interval_frames;
    }
    if (hint_) {
      has_cell_ = false;
      detect(frame);
    } else if (has_cell_) {
      has_cell_ = cell_.follow(frame);
      if (!has_cell_) detect(frame);
    } else if (frames_since_detection_ >= options_.redetect_interval_frames) {
      detect(frame);
    }

    if (has_cell_) {
      lone_needle_.reset();
    } else {
      follow_lone_needle(frame);
    }

    const PartTimer timer(timings_.report_us);
    Observation out;
    if (has_cell_) {
      out = report(cell_, view.pixel_size_um);
    } else {
      out.state = ever_ ? CellState::kLost : CellState::kNoCell;
      if (lone_needle_.valid()) out.needle = needle_pose(lone_needle_.estimate(), view.pixel_size_um);
    }
    out.time_s = time_s;
    out.frame_index = frame_index;
    return out;
  }

  void expect_cell(const CellHint& hint) {
    check(hint);
    hint_ = hint;
  }

  const TrackerOptions& options() const noexcept { return options_; }
  const TrackerTimings& timings() const noexcept { return timings_; }

 private:
  // Looks for a cell with no memory of an earlier one; a person's hint serves once.
  void detect(const FrameInput& frame) {
    const PartTimer timer(timings_.detection_us);
    frames_since_detection_ = 0;
    const std::optional<DetectionHint> hint = hint_px(frame.view.pixel_size_um);
    hint_.reset();
    load(frame.view, whole_);
    const std::optional<DetectedCell> found = detect_cell(whole_, options_, hint ? &*hint : nullptr);
    has_cell_ = found && cell_.start(frame, *found);
    // The cell on the holding pipette is the one that is worked on, not a bystander or a bubble that looks as round.
    if (found && !hint && !(has_cell_ && has_tools())) {
      const std::optional<DetectedCell> other = detect_cell(whole_, options_, nullptr, &found->circle);
      const bool better = other && cell_.start(frame, *other) && has_tools();
      if (better) has_cell_ = true;
      if (!better && has_cell_) has_cell_ = cell_.start(frame, *found);
    }
    ever_ = ever_ || has_cell_;
  }

  bool has_tools() const { return cell_.holder() || cell_.needle().valid(); }

  // A needle without a cell is followed too: it is looked for together with a cell.
  void follow_lone_needle(const FrameInput& frame) {
    const PartTimer timer(timings_.needle_us);
    if (lone_needle_.valid()) {
      const bool seen =
          lone_needle_.track(frame.image, frame.noise, {kNeedleReach_px, true, frame.needle_motion_px, {0.0, 0.0}});
      if (!seen && lone_needle_.estimate().confidence < kLeastNeedleConfidence) lone_needle_.reset();
    } else if (frames_since_detection_ == 0 && !lone_needle_.start_anywhere(frame.image, whole_, frame.noise)) {
      lone_needle_.reset();
    }
  }

  std::optional<DetectionHint> hint_px(double pixel_size_um) const {
    if (!hint_) return std::nullopt;
    DetectionHint hint;
    if (hint_->outline_um) {
      hint.outline = *hint_->outline_um / pixel_size_um;
      hint.inside = hint.outline.rowwise().mean();
    }
    if (hint_->inside_um) hint.inside = *hint_->inside_um / pixel_size_um;
    return hint;
  }

  TrackerOptions options_;
  TrackerTimings timings_;
  CellFollower cell_;
  NeedleTracker lone_needle_;
  GrayImage whole_;
  std::optional<CellHint> hint_;
  bool has_cell_ = false, ever_ = false;
  int frames_since_detection_ = 0, width_px_ = 0, height_px_ = 0;
};

MembraneTracker::MembraneTracker(TrackerOptions options) {
  check(options);
  impl_ = std::make_unique<Impl>(options);
}
MembraneTracker::~MembraneTracker() = default;
MembraneTracker::MembraneTracker(MembraneTracker&&) noexcept = default;
MembraneTracker& MembraneTracker::operator=(MembraneTracker&&) noexcept = default;

Observation MembraneTracker::process(const ImageView& image, double time_s, long frame_index, const FrameHints& hints) {
  return impl_->process(image, time_s, frame_index, hints);
}
void MembraneTracker::expect_cell(const CellHint& hint) {
  impl_->expect_cell(hint);
}
void MembraneTracker::reset() {
  impl_ = std::make_unique<Impl>(impl_->options());
}
const TrackerOptions& MembraneTracker::options() const noexcept {
  return impl_->options();
}

const TrackerTimings& MembraneTracker::timings() const noexcept {
  return impl_->timings();
}

}  // namespace pellucida
