#pragma once
#include <Eigen/Core>

#include "ContourMath.h"
#include "FrameSampler.h"
#include "NeedleTracker.h"
#include "TipNetwork.h"

namespace pellucida {

/// The other of two tools that face each other at a cell, watched until motion shows which one is the needle: the one
/// that moves into the cell while the other one rests in the picture. All lengths in px.
class RivalTool {
 public:
  enum class Verdict {
    kOpen,      ///< neither has moved, or the tool isn't seen
    kIsNeedle,  ///< it has gone into the cell, and what was taken for the needle has rested
    kIsHolder,  ///< the needle is what it was taken for
  };

  /// Watches `tool`, which is known by its tip, beside `needle`; `cell` is the circle through the part of the outline
  /// that nothing dents.
  void begin(NeedleTracker tool, const NeedleEstimate& needle, const contour::Circle& cell);
  void reset() { *this = {}; }
  bool is_watched() const noexcept { return tool_.valid(); }
  /// A later frame. After any verdict but kOpen there is nothing to watch for.
  Verdict watch(TipNetwork& tips, const FrameSampler& image, const NeedleEstimate& needle, const contour::Circle& cell);
  const NeedleTracker& tool() const noexcept { return tool_; }

 private:
  NeedleTracker tool_;
  Eigen::Vector2d center_ = Eigen::Vector2d::Zero();  // of the cell when the tool was last seen
  Eigen::Vector2d tool_start_ = Eigen::Vector2d::Zero(), needle_start_ = Eigen::Vector2d::Zero();  // their tips
  double in_cell_start_px_ = 0.0;          // of the tool's tip along its direction, from the centre
  int times_gone_ = 0, times_unseen_ = 0;  // in a row
};

}  // namespace pellucida
