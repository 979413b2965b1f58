#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "FrameSampler.h"
#include "MembraneSnakes.h"
#include "ToolFinder.h"
#include "pellucida/core/Observation.h"

namespace pellucida {

/// The needle in px: a cone with a round tip.
struct NeedleEstimate {
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< shaft to tip
  double tip_half_width = 2.0;
  double widening = 0.0;  ///< half width gained per px behind the tip
  double confidence = 0.0;
  double tip_sigma = 0.0;  ///< px along the direction
  NeedleEvidence evidence = kNoNeedleEvidence;
};

/// What is known of a frame before its needle is looked for.
struct NeedleCue {
  double reach_px = 34.0;                       ///< how far the tip may be from where it is expected
  bool in_the_clear = false;                    ///< nothing touches or covers the tip, so its cone may be learnt
  std::optional<Eigen::Vector2d> commanded_px;  ///< the motion commanded since the last frame
};

/// Follows the injection needle by its shaft's two edges, and the tip by where they end; where a dimple hides that end,
/// by the shaft's known cone.
class NeedleTracker {
 public:
  /// Looks for the tip along a tool found by voting. False when the tool's edges can't be followed.
  bool start(const FrameSampler& image, const FoundTool& tool, const contour::Circle& cell, double noise);

  /// Follows it from the last frame. False when it isn't seen.
  bool track(const FrameSampler& image, double noise, const NeedleCue& cue);

  /// This frame's contour says that the membrane's apex, which rests on the tip, is at `apex` (px, standard deviation
  /// `sigma_px` along the needle): one more piece of evidence for the tip. For frames in contact only.
  void take_dimple(const Eigen::Vector2d& apex, double sigma_px);

  const NeedleEstimate& estimate() const noexcept { return now_; }
  bool valid() const noexcept { return valid_; }
  void reset() noexcept { *this = NeedleTracker(); }
  /// How far the tip moved with the last frame.
  Eigen::Vector2d motion() const noexcept { return motion_; }

 private:
  struct Straightened;
  bool measure(const FrameSampler& image, double noise, double ahead_px, double behind_px, double edge_reach_px);
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
