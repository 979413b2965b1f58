#include "pellucida/tracking/MembraneTracker.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "CellDetector.h"
#include "CellFollower.h"
#include "ContourMath.h"
#include "CrossedCell.h"
#include "Deinterlacer.h"
#include "HintedNeedle.h"
#include "LoneNeedle.h"
#include "ObservationReport.h"
#include "PersonHints.h"
#include "PictureOrientation.h"
#include "Rereading.h"
#include "RingChoice.h"
#include "SceneReader.h"
#include "SceneVerdict.h"
#include "TrackerChecks.h"
#include "TrackerPace.h"

namespace pellucida {

class MembraneTracker::Impl {
 public:
  explicit Impl(const TrackerOptions& options) : options_(options), cell_(options) {}

  Observation process(const ImageView& view, double time_s, long frame_index, const FrameHints& hints) {
    check(view);
    check(hints);
    timings_ = {};
    const double noise = noise_level(FrameSampler(view));
    const ImageView whole = fields_.process(view, noise);
    if (!laid_.is_chosen()) laid_.choose(whole);
    const ImageView laid = laid_.lay(whole);
    const FrameSampler image(laid);
    FrameInput frame{laid, image, laid.data == view.data ? noise : noise_level(image), {}, &timings_};
    std::optional<Eigen::Vector2d> motion_px;
    if (hints.needle_motion_um) motion_px = laid_.laid_direction(*hints.needle_motion_um) / view.pixel_size_um;
    command_.begin(motion_px);
    if (motion_px) frame.command = &command_;
    if (options_.detection != Detection::kLines) frame.networks = &reader_;
    if (by_scene()) frame.reader = &reader_;
    ++frames_since_detection_;
    // Another size is another camera setting: nothing is where it was.
    if (view.width_px != width_px_ || view.height_px != height_px_) {
      width_px_ = view.width_px;
      height_px_ = view.height_px;
      search_again();
    }
    outcomes_ = {};
    if (hints_.has_cell()) {
      has_cell_ = false;
      detect(frame);
      outcomes_.cell = has_cell_ ? "found" : "nothing like a cell was found there";
    } else if (has_cell_) {
      if (needle_search_.is_due(cell_.needle().valid(), frames_since_detection_) && is_needle_missed()) look(frame);
      const RigidMove motion = cell_.motion();
      has_cell_ = cell_.follow(frame) && is_confirmed(frame);
      if (!has_cell_) {
        lost_ = cell_.memory(motion);
        searches_ = 0;
        find_again(frame);
      }
    } else if (frames_since_detection_ >= options_.redetect_interval_frames) {
      find_again(frame);
    }

    // Lines look for a needle alone only in the frames in which a cell is looked for too.
    const bool has_lines = !by_scene() && frames_since_detection_ == 0;
    has_cell_ ? lone_needle_.reset() : lone_needle_.follow(frame, reader_, has_lines ? &whole_ : nullptr);
    if (const std::optional<Eigen::Vector2d> tip = hints_.take_tip(laid_, view.pixel_size_um))
      outcomes_.needle = start_hinted_needle(frame, *tip) ? "followed" : "no straight shaft was found that ends there";
    if (const std::optional<Eigen::Vector2d> place = hints_.take_holder(laid_, view.pixel_size_um))
      outcomes_.holder = start_hinted_holder(frame, *place);

    const PartTimer timer(timings_.report_us);
    Observation out;
    if (has_cell_) {
      out = report(cell_, view.pixel_size_um);
    } else {
      out.state = ever_ ? CellState::kLost : CellState::kNoCell;
      if (lone_needle_.valid()) out.needle = needle_pose(lone_needle_.estimate(), view.pixel_size_um);
      out.refused_radius_um = refused_radius_px_ * view.pixel_size_um;
    }
    laid_.take_back(out);
    out.time_s = time_s;
    out.frame_index = frame_index;
    return out;
  }

  PersonHints& hints() noexcept { return hints_; }
  void exclude_cell(const Eigen::Vector2d& place_um) {
    hints_.add_no_cell(place_um);
    search_again();
    ever_ = false;
  }
  void take_back_hint() {
    const std::optional<PersonHints::Kind> kind = hints_.take_back();
    if (!kind) return;
    if (*kind != PersonHints::Kind::kTip) return search_again();
    cell_.forget_needle();
    lone_needle_.reset();
  }
  const HintOutcomes& hint_outcomes() const noexcept { return outcomes_; }
  const TrackerOptions& options() const noexcept { return options_; }
  const TrackerTimings& timings() const noexcept { return timings_; }

 private:
  using Detection = TrackerOptions::Detection;

  void search_again() {
    has_cell_ = false;
    lost_.reset();
    lone_needle_.reset();
    frames_since_detection_ = options_.redetect_interval_frames;
  }

  // What a person called no cell.
  bool is_excluded(const FrameInput& frame, const contour::Circle& circle) const {
    return hints_.is_no_cell(laid_, frame.view.pixel_size_um, circle);
  }
  bool is_excluded(const FrameInput& frame, const SceneCell& seen) const { return is_excluded(frame, seen.circle()); }

  // By lines, and nothing that a person called no cell.
  std::optional<DetectedCell> detect_by_lines(const FrameInput& frame) const {
    std::optional<DetectedCell> found = detect_cell(whole_, options_);
    if (!found || !is_excluded(frame, found->circle)) return found;
    found = detect_cell(whole_, options_, nullptr, &found->circle);
    if (found && is_excluded(frame, found->circle)) found.reset();
    return found;
  }

  bool start_hinted_needle(FrameInput& frame, const Eigen::Vector2d& tip) {
    const PartTimer timer(timings_.needle_us);
    if (has_cell_) {
      needle_confirmed_ = true;
      return cell_.expect_needle(frame, tip);
    }
    load(frame.view, whole_);
    NeedleTracker found;
    if (!start_at_hint(found, frame, find_tools(whole_), tip)) return false;
    lone_needle_.take(std::move(found));
    return true;
  }

  const char* start_hinted_holder(const FrameInput& frame, const Eigen::Vector2d& place) {
    if (!has_cell_) return "no cell is followed that it could hold";
    return cell_.expect_holder(frame, place) ? "followed" : "no straight pipette was found there";
  }

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
    for (std::size_t k = 0; k < scene_.cells.size(); ++k)
      look_past(scene_, scene_.cells[k].circle(), frame.image, reader_.tips());
    frame.seen = frame.scene = &scene_;
  }

  // Looks for a cell, which may be the one that was lost just now.
  void find_again(FrameInput& frame) {
    detect(frame);
    if (has_cell_ && lost_) cell_.resume(frame, *lost_);
    if (has_cell_ || ++searches_ >= kRemembered_searches) lost_.reset();
  }

  // Looks for a cell with no memory of an earlier one; a person's hint serves once.
  void detect(FrameInput& frame) {
    look(frame);
    const PartTimer timer(timings_.detection_us);
    rereading_.drop();
    frames_since_detection_ = 0;
    refused_radius_px_ = 0.0;
    frame.refused_radius_px = &refused_radius_px_;
    const std::optional<DetectionHint> hint = hints_.take_cell(laid_, frame.view.pixel_size_um);
    frame.is_vouched = hint.has_value();
    has_cell_ = hint ? start_at(frame, *hint) : start_best(frame);
    if (hint && has_cell_) hints_.forget_no_cell(laid_, frame.view.pixel_size_um, cell_.circle_now());
    ever_ = ever_ || has_cell_;
  }

  bool start_at(FrameInput& frame, const DetectionHint& hint) {
    const std::optional<DetectedCell> found = detect_cell(whole_, options_, &hint);
    const auto by_lines = [&] { return found && cell_.start(frame, *found); };
    return options_.detection == Detection::kAuto ? start_confirmed(frame, found, by_lines, &hint) : by_lines();
  }

  bool start_best(FrameInput& frame) {
    if (options_.detection == Detection::kScene) return start_seen(frame, nullptr);
    const std::optional<DetectedCell> found = detect_by_lines(frame);
    const auto by_lines = [&] { return found && start_at_tools(frame, *found); };
    return options_.detection == Detection::kAuto ? start_confirmed(frame, found, by_lines, nullptr) : by_lines();
  }

  // A cell of the scene; with a hint the one that was drawn, or else one that holds the point.
  bool start_seen(const FrameInput& frame, const DetectionHint* hint) {
    const bool is_drawn = hint != nullptr && hint->is_drawn() && can_be_a_cell(whole_, hint->outline);
    if (is_drawn && cell_.start(frame, detected(hint->outline))) return true;
    const auto start_one = [&](bool bystander) {
      return std::any_of(scene_.cells.begin(), scene_.cells.end(), [&](const SceneCell& seen) {
        const bool is_meant = hint ? contour::contains(seen.outer, hint->inside) : !is_excluded(frame, seen);
        return seen.share > kLeastCellShare && is_meant && is_bystander(seen.circle(), scene_) == bystander &&
               cell_.start(frame, detected(seen));
      });
    };
    return start_one(false) || start_one(true);
  }

  // By the network where it is at home, and where lines and network don't agree: lines follow a halo, the inner
  // boundary or a neighbour as surely as a membrane. Else by lines, in doubt where only they see a cell.
  template <class ByLines>
  bool start_confirmed(FrameInput& frame, const std::optional<DetectedCell>& found, const ByLines& by_lines,
                       const DetectionHint* hint) {
    choose_scene(frame, false);
    const bool has_lines = by_lines();
    if (has_lines) {
      if (scene_.cells.empty()) add_ring_behind(scene_, whole_, options_, cell_.circle_now(), frame.image, reader_);
      look_past(scene_, cell_.circle_now(), frame.image, reader_.tips());
    }
    const LinesVerdict verdict = has_lines ? judge_with_needle(frame, by_lines) : LinesVerdict{};
    if (has_lines && verdict.is_by_lines()) return follow_lines(verdict);
    CellFollower lines = std::exchange(cell_, CellFollower(options_));
    choose_scene(frame, true);
    frame.least_score = least_score(verdict);
    if (found && scene_.cells.empty())
      add_likeliest_ring(scene_, whole_, options_, found->circle, frame.image, reader_);
    const bool has_seen = start_seen(frame, hint);
    const bool are_apart = has_lines && has_seen && is_bystander(cell_, scene_) != is_bystander(lines, scene_);
    const bool strays = are_apart && is_bystander(cell_, scene_);
    if (has_seen && !strays && (!has_lines || are_apart || is_preferred(cell_, verdict))) return true;
    // Where the whole picture gives the network no start, the lines may.
    if (!has_seen && has_lines && !verdict.is_same() && cell_.start(frame, detected(lines)) && is_known(cell_))
      return true;
    choose_scene(frame, false);
    cell_ = std::move(lines);
    return has_lines && (!verdict.is_bubble || hint != nullptr) && follow_lines(verdict);
  }

  bool follow_lines(const LinesVerdict& verdict) {
    is_start_confirmed_ = verdict.is_confirmed();
    cell_.doubt(!is_start_confirmed_, !verdict.is_same_needle);
    needle_confirmed_ = cell_.needle().valid();
    disagreements_ = 0;
    return true;
  }

  // What the networks make of the cell found by its lines; where they have it at the same place, a needle that lines
  // alone miss or take for another is looked for where the scene has one.
  template <class ByLines>
  LinesVerdict judge_with_needle(FrameInput& frame, const ByLines& by_lines) {
    LinesVerdict first = judge_lines(cell_, scene_, frame.image, reader_);
    if (!first.is_same() || first.is_same_needle || scene_.needles.empty()) return first;
    CellFollower lines = std::exchange(cell_, CellFollower(options_));
    frame.scene = &scene_;
    const bool has_started = by_lines();
    frame.scene = nullptr;
    if (has_started) {
      const LinesVerdict again = judge_lines(cell_, scene_, frame.image, reader_);
      if (again.is_same() && again.is_same_needle && cell_.needle().valid()) {
        // The scene is no witness to what it gave itself, and the cell stays in doubt; even lines are, where those
        // before were of another kind, as along one wall, and not the same with another end.
        first.is_same_needle = cell_.needle().is_even() && !lines.needle().is_even();
        return first;
      }
    }
    cell_ = std::move(lines);
    return first;
  }

  void choose_scene(FrameInput& frame, bool scene) {
    scene_chosen_ = scene;
    frame.reader = scene ? &reader_ : nullptr;
    frame.scene = scene ? &scene_ : nullptr;
  }

  // Where lines alone follow the cell: now and then the networks read where it and the tip are. Should they lie
  // elsewhere, the cell is followed in doubt, and looked for anew once nothing touches it.
  bool is_where_networks_read(const FrameInput& frame) {
    if (!is_start_confirmed_) return true;
    if (const auto read = rereading_.take()) {
      const bool is_same =
          read->is_same_outline && (read->is_same_needle || cell_.take_bevel(frame.image, reader_.tips()));
      disagreements_ = is_same ? 0 : disagreements_ + 1;
      cell_.doubt(disagreements_ >= kDisagreements, disagreements_ >= kDisagreements);
    }
    if (frames_since_detection_ % kReread_frames == 0) rereading_.ask(frame.view, cell_);
    return !(cell_.is_doubtful() && cell_.state() == CellState::kFree);
  }

  // And a needle that came into view is where the network sees one, and a network that sees a needle where lines see
  // none is right.
  bool is_confirmed(FrameInput& frame) {
    if (options_.detection != Detection::kAuto || by_scene()) return true;
    if (!is_where_networks_read(frame)) return false;
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
    const bool is_elsewhere = frame.seen != nullptr && is_bystander(found.circle, *frame.seen);
    const bool started = cell_.start(frame, found);
    if (started && has_tools() && !is_elsewhere) return true;
    const std::optional<DetectedCell> other = detect_cell(whole_, options_, nullptr, &found.circle);
    const bool is_meant =
        other && !is_excluded(frame, other->circle) && !(is_elsewhere && is_bystander(other->circle, *frame.seen));
    if (is_meant && cell_.start(frame, *other) && has_tools()) return true;
    return started && cell_.start(frame, found);
  }

  // By lines: where they aren't to be trusted alone, or something pushes and isn't seen.
  bool is_needle_missed() const {
    return by_scene() || cell_.is_doubtful() || cell_.state() != CellState::kFree || cell_.is_dented();
  }

  bool has_tools() const { return cell_.holder() || cell_.needle().valid(); }

  TrackerOptions options_;
  TrackerTimings timings_;
  Deinterlacer fields_;
  PictureOrientation laid_;
  CellFollower cell_;
  std::optional<CellFollower::Memory> lost_;  // until a cell is found
  int searches_ = 0;                          // for it
  LoneNeedle lone_needle_;
  GrayImage whole_;
  SceneReader reader_;
  SceneReading scene_;
  Rereading rereading_;
  NeedleSearch needle_search_;
  PersonHints hints_;
  HintOutcomes outcomes_;
  CommandedMotion command_;
  bool has_cell_ = false, ever_ = false;
  bool scene_chosen_ = false;        // by kAuto
  bool is_start_confirmed_ = false;  // the cell that lines follow, by the networks at its first sight
  int disagreements_ = 0;            // of the networks with the lines, in a row
  bool needle_confirmed_ = false;    // the needle that lines follow, by the scene
  double refused_radius_px_ = 0.0;   // of what was a cell but for its size when one was last looked for
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
  impl_->hints().add_cell(hint);
}
void MembraneTracker::expect_needle(const Eigen::Vector2d& tip_um) {
  impl_->hints().add_tip(tip_um);
}
void MembraneTracker::expect_holder(const Eigen::Vector2d& place_um) {
  impl_->hints().add_holder(place_um);
}
void MembraneTracker::exclude_cell(const Eigen::Vector2d& place_um) {
  impl_->exclude_cell(place_um);
}
void MembraneTracker::take_back_hint() {
  impl_->take_back_hint();
}
const HintOutcomes& MembraneTracker::hint_outcomes() const noexcept {
  return impl_->hint_outcomes();
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
