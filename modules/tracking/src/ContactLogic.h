#pragma once
#include <algorithm>

#include "pellucida/core/Observation.h"
#include "pellucida/tracking/TrackerOptions.h"

namespace pellucida {

/// Tells free, contact and punctured apart from two depths along the needle's axis, px past the resting membrane:
/// of the needle's tip, and of the membrane under it.
class ContactLogic {
 public:
  explicit ContactLogic(const TrackerOptions& options) : options_(options) {}

  struct Depths {
    double tip_px = 0.0;  ///< negative while the needle is away
    double membrane_px = 0.0;
    bool needle_seen = false;
    double sigma_px = 0.25;      ///< standard deviation of the membrane's
    double tip_sigma_px = 0.0;   ///< of the tip's
    bool is_pushed = false;      ///< beside the tip the dimple is as deep as the needle's way makes it
    double past_sigma_px = 0.0;  ///< of how far the tip is past the resting membrane; 0: not known well enough to count
  };

  /// The state after this frame.
  /// Contact: a cumulative sum test (Page 1954) on the membrane's depth in units of its sigma; a depth below
  /// `contact_px` counts for nothing, and a single frame decides only where the tip is seen to have passed the resting
  /// membrane too. A tip just past it, by more than its error, is in contact: so shallow a dent can't be distinguished
  /// from none. Release: two frames in a row with the membrane back, the tip no more just past it, or the tip away.
  /// Puncture: the membrane leaves the tip behind by `puncture_drop_ratio` of its depth, and the dimple beside it is
  /// not pushed any more; it ends when the tip has left the cell, or three frames in a row show the tip on the membrane
  /// again or that dimple pushed.
  CellState update(const Depths& now) {
    const double floor_px = kShallow * options_.contact_px;
    if (state_ == CellState::kPunctured) {
      if (now.needle_seen && now.tip_px < 0.0) reset(CellState::kFree);
      follow_together(now);
      return state_;
    }
    if (state_ == CellState::kFree) {
      // A membrane that moves while the tip is elsewhere is not pushed by it.
      const bool near = now.needle_seen && now.tip_px > -std::max(options_.contact_px, 3.0 * now.sigma_px);
      const double depth =
          now.membrane_px >= options_.contact_px ? now.membrane_px / std::max(now.sigma_px, 0.05) : 0.0;
      const bool has_passed =
          now.tip_px > std::max(options_.contact_px, kSure * std::hypot(now.tip_sigma_px, now.sigma_px));
      const double most = has_passed ? kDecision : kMostOfOneFrame;
      evidence_ = near ? std::max(0.0, evidence_ + std::min(depth - kAllowance, most)) : 0.0;
      if (evidence_ >= kDecision || is_just_past(now)) {
        reset(CellState::kContact);
        deepest_px_ = now.membrane_px;
      }
      return state_;
    }
    if (!now.needle_seen) return state_;
    deepest_px_ = std::max(now.membrane_px, 0.9 * deepest_px_);
    const bool left_behind = !now.is_pushed && now.tip_px - now.membrane_px > apart_px(now);
    if (deepest_px_ > floor_px && left_behind && now.tip_px > floor_px) {
      state_ = CellState::kPunctured;
      return state_;
    }
    const bool is_back = now.membrane_px < 0.5 * options_.contact_px && !is_just_past(now);
    const bool apart = is_back || now.tip_px < -std::max(options_.contact_px, 3.0 * now.sigma_px);
    apart_frames_ = apart ? apart_frames_ + 1 : 0;
    if (apart_frames_ >= kReleaseFrames) reset(CellState::kFree);
    return state_;
  }

  /// At the first sight of a cell: what that one frame shows.
  void reset(CellState first_sight) {
    state_ = first_sight;
    evidence_ = deepest_px_ = 0.0;
    apart_frames_ = together_frames_ = 0;
  }

  CellState state() const noexcept { return state_; }

 private:
  bool is_just_past(const Depths& now) const {
    return now.needle_seen && now.past_sigma_px > 0.0 && now.tip_px < kShallow * options_.contact_px &&
           now.tip_px > std::max(kLeastPast * options_.contact_px, kPast * now.past_sigma_px);
  }

  double apart_px(const Depths& now) const {
    return std::max(options_.puncture_drop_ratio * deepest_px_, kSure * now.tip_sigma_px);
  }

  // A membrane that lies on the tip again, deep in the cell, has not given way.
  void follow_together(const Depths& now) {
    if (state_ != CellState::kPunctured || !now.needle_seen) return;
    const bool on_tip = now.membrane_px > 0.5 * deepest_px_ && now.tip_px - now.membrane_px < kTogether * apart_px(now);
    const bool together = now.membrane_px > 4.0 * options_.contact_px && (on_tip || now.is_pushed);
    together_frames_ = together ? together_frames_ + 1 : 0;
    if (together_frames_ < kTogetherFrames) return;
    reset(CellState::kContact);
    deepest_px_ = now.membrane_px;
  }

  // In standard deviations: what a frame must exceed to count, what decides, the most that one frame may add; by how
  // much a tip must have passed the membrane.
  static constexpr double kAllowance = 1.5, kDecision = 4.0, kMostOfOneFrame = 3.2, kSure = 3.0;
  // Likewise of a tip that alone says it, and of `contact_px` its least way past. With 0.5 px instead of 0.3, none of
  // 4,500 frames in which the needle was near and hadn't touched (plain drawings 80001 to 81455 of validation, tuning
  // 306001 to 306044, wide 307001 to 307044) had it so far past; with 0.3 px one of 709 (80001 to 81455, the end seen
  // against the membrane's line), 0.08 px before its contact, and 100 of 1,700 frames of shallow contact more are
  // called so. Up to so many `contact_px` a dent is shallow.
  static constexpr double kPast = 1.75, kLeastPast = 0.6, kShallow = 4.0;
  static constexpr int kReleaseFrames = 2;
  // Of the way that counts as apart, what counts as together again; frames in a row of it.
  static constexpr double kTogether = 0.5;
  static constexpr int kTogetherFrames = 3;

  TrackerOptions options_;
  CellState state_ = CellState::kFree;
  double evidence_ = 0.0, deepest_px_ = 0.0;
  int apart_frames_ = 0, together_frames_ = 0;
};

}  // namespace pellucida
