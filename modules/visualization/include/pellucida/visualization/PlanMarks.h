#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

namespace pellucida {

/// What of a plan can be dragged.
enum class PlanHandle { kNone, kTarget, kEntry, kDepthStop };

/// An injection plan as a view draws it. Frame W, image plane, um.
struct PlanMarks {
  Eigen::Vector2d approach_um = Eigen::Vector2d::Zero();    ///< where the straight way begins
  Eigen::Vector2d entry_um = Eigen::Vector2d::Zero();       ///< on the resting outer membrane
  Eigen::Vector2d target_um = Eigen::Vector2d::Zero();      ///< where to deposit
  Eigen::Vector2d depth_stop_um = Eigen::Vector2d::Zero();  ///< where the tip is stopped
  double corridor_um = 0.0;                                 ///< half width of the guide about the way
  bool guided = true;                                       ///< the guide is on
  bool has_handles = false;                                 ///< rings about what can be dragged
  PlanHandle handle = PlanHandle::kNone;                    ///< the one under the mouse: a larger ring

  bool operator==(const PlanMarks&) const = default;
};

/// A place that a person pointed at, as a view draws it.
struct HintMark {
  Eigen::Vector2d place_um = Eigen::Vector2d::Zero();  ///< frame W, image plane
  std::string text;                                    ///< UTF-8
  /// Further places, joined to it by a line: in place of the ring each has a dot. Empty: the ring.
  std::vector<Eigen::Vector2d> further_um;
};

}  // namespace pellucida
