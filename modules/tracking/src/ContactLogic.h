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
  };

  /// The state after this frame. Contact and release need `contact_confirm_frames` frames that agree; a puncture is the
  /// membrane's leaving the tip behind by `puncture_drop_ratio` of its depth, and ends when the tip has left the cell.
  CellState update(const Depths& now) {
    const double floor_px = 4.0 * options_.contact_px;
    if (state_ == CellState::kPunctured) {
      if (now.needle_seen && now.tip_px < 0.0) state_ = CellState::kFree;
      deepest_px_ = 0.0;
      votes_ = 0;
      return state_;
    }
    if (state_ == CellState::kContact && now.needle_seen) {
      deepest_px_ = std::max(now.membrane_px, 0.9 * deepest_px_);
      const bool left_behind = now.tip_px - now.membrane_px > options_.puncture_drop_ratio * deepest_px_;
      if (deepest_px_ > floor_px && left_behind && now.tip_px > floor_px) return state_ = CellState::kPunctured;
    }
    const bool touches = now.needle_seen && now.membrane_px > options_.contact_px && now.tip_px > 0.0;
    const bool apart = now.needle_seen && (now.membrane_px < 0.5 * options_.contact_px || now.tip_px < -1.0);
    const bool changes = state_ == CellState::kContact ? apart : touches;
    votes_ = changes ? votes_ + 1 : 0;
    if (votes_ >= options_.contact_confirm_frames) {
      state_ = state_ == CellState::kContact ? CellState::kFree : CellState::kContact;
      deepest_px_ = now.membrane_px;
      votes_ = 0;
    }
    return state_;
  }

  /// At the first sight of a cell: what that one frame shows.
  void reset(CellState first_sight) {
    state_ = first_sight;
    votes_ = 0;
    deepest_px_ = 0.0;
  }

  CellState state() const noexcept { return state_; }

 private:
  TrackerOptions options_;
  CellState state_ = CellState::kFree;
  int votes_ = 0;
  double deepest_px_ = 0.0;
};

}  // namespace pellucida
