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
  double widening = 0.0;       ///< half width gained per px behind the tip
  double confidence = 0.0;
};

/// Follows the injection needle by its shaft's two edges, and the tip by where they end.
class NeedleTracker {
 public:
  /// Looks for the tip along a tool found by voting. False when the tool's edges can't be followed.
  bool start(const GrayImage& image, const FoundTool& tool, const contour::Circle& cell, double noise);

  /// Follows it from the last frame. `shift` is the motion expected besides the needle's own. False when it isn't seen.
  bool track(const GrayImage& image, double noise, double reach_px);

  const NeedleEstimate& estimate() const noexcept { return now_; }
  bool valid() const noexcept { return valid_; }
  void reset() noexcept { *this = NeedleTracker(); }
  /// How far the tip moved with the last frame.
  Eigen::Vector2d motion() const noexcept { return motion_; }

 private:
  struct Straightened;
  bool measure(const GrayImage& image, double noise, double ahead_px, double behind_px, double edge_reach_px);

  NeedleEstimate now_;
  Eigen::Vector2d motion_ = Eigen::Vector2d::Zero();
  double presence_ = 0.0;   // learnt evidence per station of a shaft in view
  bool valid_ = false;
};

}  // namespace pellucida
