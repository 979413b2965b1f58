#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "GrayImage.h"
#include "MembraneSnakes.h"
#include "ToolFinder.h"

namespace pellucida {

/// The needle in px: a cone with a round tip.
struct NeedleEstimate {
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< shaft to tip
  double tip_half_width = 2.0;
  double widening = 0.0;  ///< half width gained per px behind the tip
  double confidence = 0.0;
};

/// Follows the injection needle by its shaft's two edges, and the tip by where they end; where a dimple hides that end,
/// by the shaft's known cone.
class NeedleTracker {
 public:
  /// Looks for the tip along a tool found by voting. False when the tool's edges can't be followed.
  bool start(const GrayImage& image, const FoundTool& tool, const contour::Circle& cell, double noise);

  /// Follows it from the last frame. `shift` is the motion expected besides the needle's own. False when it isn't seen.
  /// `in_the_clear`: nothing touches or covers the tip, so its cone may be learnt.
  bool track(const GrayImage& image, double noise, double reach_px, bool in_the_clear);

  const NeedleEstimate& estimate() const noexcept { return now_; }
  bool valid() const noexcept { return valid_; }
  void reset() noexcept { *this = NeedleTracker(); }
  /// How far the tip moved with the last frame.
  Eigen::Vector2d motion() const noexcept { return motion_; }

 private:
  struct Straightened;
  bool measure(const GrayImage& image, double noise, double ahead_px, double behind_px, double edge_reach_px);
  void learn_cone();

  NeedleEstimate now_;
  Eigen::Vector2d motion_ = Eigen::Vector2d::Zero();
  // The cone, learnt in the clear: how wide the needle is at its tip, and how fast it widens. It tells where the tip is
  // when the tip itself is hidden in the dimple.
  double cone_half_width_ = 0.0, cone_widening_ = 0.0;
  int cone_frames_ = 0;
  bool valid_ = false;
};

}  // namespace pellucida
