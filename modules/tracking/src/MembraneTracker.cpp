#include "pellucida/tracking/MembraneTracker.h"

#include <algorithm>
#include <utility>

#include "CellDetector.h"
#include "CellFollower.h"
#include "ContourMath.h"
#include "ObservationReport.h"
#include "SceneReader.h"
#include "SceneVerdict.h"
#include "TrackerChecks.h"

namespace pellucida {
namespace {

// A needle with no cell: how far it may go between two frames, and when it counts as gone.
constexpr double kNeedleReach_px = 34.0, kLeastNeedleConfidence = 0.1;
// While a cell has no needle: frames between two looks at the whole image; frames in which a cell is new, and a third
// as many lie between them.
constexpr int kNeedleSearch_frames = 10, kNewCell_frames = 10;
// Of the way from where a needle without a cell was followed to, to where its tip is read.
constexpr double kLoneTipShare = 0.5;
// While a cell is followed by lines and has no needle: frames between two looks of the network.
constexpr int kConfirmation_frames = 30;

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
    if (by_scene()) frame.reader = &reader_;
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
      if (!cell_.needle().valid() && is_needle_search_due()) look(frame);
      has_cell_ = cell_.follow(frame) && is_confirmed(frame);
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
  using Detection = TrackerOptions::Detection;

  // How the present cell is followed, and the next one looked for.
  bool by_scene() const noexcept {
    return options_.detection == Detection::kScene || (options_.detection == Detection::kAuto && scene_chosen_);
  }

  // The whole image, and what the network shows of it.
  void look(FrameInput& frame) {
    const PartTimer timer(timings_.detection_us);
    load(frame.view, whole_);
    if (options_.detection == Detection::kLines) return;
    scene_ = reader_.read(whole_);
    if (by_scene()) frame.scene = &scene_;
  }

  // Looks for a cell with no memory of an earlier one; a person's hint serves once.
  void detect(FrameInput& frame) {
    look(frame);
    const PartTimer timer(timings_.detection_us);
    frames_since_detection_ = 0;
    const std::optional<DetectionHint> hint = hint_px(frame.view.pixel_size_um);
    hint_.reset();
    has_cell_ = hint ? start_at(frame, *hint) : start_best(frame);
    ever_ = ever_ || has_cell_;
  }

  bool start_at(FrameInput& frame, const DetectionHint& hint) {
    const std::optional<DetectedCell> found = detect_cell(whole_, options_, &hint);
    const auto by_lines = [&] { return found && cell_.start(frame, *found); };
    return options_.detection == Detection::kAuto ? start_confirmed(frame, by_lines, hint.inside) : by_lines();
  }

  bool start_best(FrameInput& frame) {
    if (options_.detection == Detection::kScene) return start_seen(frame, std::nullopt);
    const std::optional<DetectedCell> found = detect_cell(whole_, options_);
    const auto by_lines = [&] { return found && start_at_tools(frame, *found); };
    return options_.detection == Detection::kAuto ? start_confirmed(frame, by_lines, std::nullopt) : by_lines();
  }

  // A cell of the scene; one that holds the point, if one is given.
  bool start_seen(const FrameInput& frame, const std::optional<Eigen::Vector2d>& inside) {
    return std::any_of(scene_.cells.begin(), scene_.cells.end(), [&](const SceneCell& seen) {
      const bool is_meant = !inside || contour::contains(seen.outer, *inside);
      return seen.share > kLeastCellShare && is_meant && cell_.start(frame, detected(seen));
    });
  }

  // By the network where it is at home; else by lines, in doubt where it does not confirm them.
  template <class ByLines>
  bool start_confirmed(FrameInput& frame, const ByLines& by_lines, const std::optional<Eigen::Vector2d>& inside) {
    choose_scene(frame, false);
    const bool has_lines = by_lines();
    const bool is_confirmed = has_lines && confirms(scene_, cell_);
    const bool is_a_bubble = has_lines && !inside && is_bubble(cell_, scene_);
    choose_scene(frame, true);
    if (start_seen(frame, inside) && (!has_lines || is_familiar(cell_))) return true;
    choose_scene(frame, false);
    if (!has_lines || is_a_bubble || !by_lines()) return false;
    if (!is_confirmed) cell_.doubt();
    needle_confirmed_ = cell_.needle().valid();
    return true;
  }

  void choose_scene(FrameInput& frame, bool scene) {
    scene_chosen_ = scene;
    frame.reader = scene ? &reader_ : nullptr;
    frame.scene = scene ? &scene_ : nullptr;
  }

  // Where lines alone follow the cell: a needle that came into view is where the network sees one, and a network that
  // sees a needle where lines see none is right.
  bool is_confirmed(FrameInput& frame) {
    if (options_.detection != Detection::kAuto || by_scene()) return true;
    if (cell_.is_doubtful() || cell_.state() != CellState::kFree) return true;
    const bool has_needle = cell_.needle().valid();
    const bool is_due = has_needle ? !needle_confirmed_ : frames_since_detection_ % kConfirmation_frames == 0;
    needle_confirmed_ = has_needle;
    if (!is_due) return true;
    look(frame);
    return is_needle_confirmed(cell_, scene_);
  }

  // The cell on the holding pipette is the one that is worked on, not a bystander or a bubble that looks as round.
  bool start_at_tools(const FrameInput& frame, const DetectedCell& found) {
    const bool started = cell_.start(frame, found);
    if (started && has_tools()) return true;
    const std::optional<DetectedCell> other = detect_cell(whole_, options_, nullptr, &found.circle);
    if (other && cell_.start(frame, *other) && has_tools()) return true;
    return started && cell_.start(frame, found);
  }

  bool is_needle_search_due() const {
    return by_scene() &&
           frames_since_detection_ % (frames_since_detection_ < kNewCell_frames ? 3 : kNeedleSearch_frames) == 0;
  }

  bool has_tools() const { return cell_.holder() || cell_.needle().valid(); }

  // A needle without a cell is followed too: it is looked for together with a cell.
  void follow_lone_needle(const FrameInput& frame) {
    const PartTimer timer(timings_.needle_us);
    if (lone_needle_.valid()) {
      const NeedleCue cue{kNeedleReach_px, true, frame.needle_motion_px, {0.0, 0.0}, std::nullopt};
      const bool seen = lone_needle_.is_read() ? lone_needle_.follow_read(reader_.tips(), frame.image, cue)
                                               : lone_needle_.track(frame.image, frame.noise, cue);
      if (!seen && lone_needle_.estimate().confidence < kLeastNeedleConfidence) lone_needle_.reset();
      if (seen && by_scene() && !lone_needle_.is_read())
        lone_needle_.read_tip(reader_.tips(), frame.image, kLoneTipShare);
    } else if (by_scene()
                   ? frame.scene == nullptr || !start_lone_needle(frame)
                   : frames_since_detection_ == 0 && !lone_needle_.start_anywhere(frame.image, whole_, frame.noise)) {
      lone_needle_.reset();
    }
  }

  bool start_lone_needle(const FrameInput& frame) {
    return std::any_of(scene_.needles.begin(), scene_.needles.end(), [&](const SceneTool& seen) {
      const ExpectedTip expected = expected_tip(seen);
      if (!lone_needle_.start(frame.image, found_tool(seen), frame.noise, &expected))
        return lone_needle_.start_read(reader_.tips(), frame.image, {seen.tip, seen.direction}, seen.half_width_px);
      lone_needle_.read_tip(reader_.tips(), frame.image, 1.0);
      return true;
    });
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
  SceneReader reader_;
  SceneReading scene_;
  std::optional<CellHint> hint_;
  bool has_cell_ = false, ever_ = false;
  bool scene_chosen_ = false;      // by kAuto
  bool needle_confirmed_ = false;  // the needle that lines follow, by the scene
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
