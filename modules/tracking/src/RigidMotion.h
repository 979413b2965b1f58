#pragma once
#include <Eigen/Core>
#include <vector>

#include "FrameSampler.h"

namespace pellucida {

/// Follows a set of pixels that move together (the holding pipette) by least squares on their grey values, with gain
/// and offset free: tells a drift of the stage from a deformation of the cell.
class RigidMotion {
 public:
  /// Keeps the look of the pixels `points` (px) of `image` as the reference.
  /// False when, with pixel noise of standard deviation `noise`, they could not tell a motion in every direction to 0.1
  /// px.
  bool learn(const FrameSampler& image, const std::vector<Eigen::Vector2d>& points, double noise);

  /// Finds the motion since `learn`, px; starts from the last one, and from the last one plus `hint` (a motion
  /// something else made, which the holder may share). `reach_px` bounds the step. False when the fit fails.
  bool track(const FrameSampler& image, double reach_px, const Eigen::Vector2d& hint);

  const Eigen::Vector2d& motion() const noexcept { return motion_; }
  bool valid() const noexcept { return !points_.empty(); }
  void reset() noexcept { *this = RigidMotion(); }

 private:
  bool refine(const FrameSampler& image, Eigen::Vector2d& motion, double& residual) const;

  std::vector<Eigen::Vector2d> points_;
  std::vector<double> values_;
  double noise_ = 0.0;
  double spread_ = 0.0;  // standard deviation of the reference's grey values
  Eigen::Vector2d motion_ = Eigen::Vector2d::Zero();
};

}  // namespace pellucida
