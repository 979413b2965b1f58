#pragma once
#include <Eigen/Core>

#include "CellDetector.h"
#include "FrameSampler.h"
#include "MembraneSnakes.h"
#include "RegionBorder.h"
#include "Snake.h"

namespace pellucida {

/// The zona pellucida whose outer edge is no line but a border between regions, as in most pictures of real oocytes: it
/// moves with the oolemma, which the snakes follow, and its outer edge is measured anew in each frame. The inner edge
/// of a perivitelline gap is seen too badly for that: it keeps the distance to the outer edge that the detection found.
class SoftZona {
 public:
  /// Begins with what the detection found round the oolemma `line`; forgets the zona it held. Without a border in
  /// `cell` there is nothing to follow.
  void start(const FrameSampler& image, double noise, const DetectedCell& cell, const SnakeContour& line);

  /// Follows into the next frame, after the oolemma has been followed.
  void follow(const FrameSampler& image, double noise, const SnakeContour& line);

  bool valid() const noexcept { return outer_.points.cols() > 0; }
  bool has_gap() const noexcept { return gap_.points.cols() > 0; }
  const SnakeContour& outer() const noexcept { return outer_; }
  /// The zona's inner edge; on the oolemma where there is no gap.
  const SnakeContour& gap() const noexcept { return gap_; }
  /// Mean radius of the outer edge at first sight, px.
  double rest_radius() const noexcept { return rest_radius_; }

 private:
  void measure(const FrameSampler& image, double noise, double reach_px);
  void place_gap(const SnakeContour& line);

  SnakeContour outer_, gap_;
  Eigen::VectorXd gap_ratio_;  // of the way from the outer edge to the centre, by angle
  Eigen::Vector2d line_center_ = Eigen::Vector2d::Zero();
  double window_px_ = 6.0, rest_radius_ = 0.0;
  RegionBorder border_;
  Eigen::MatrixXf evidence_, likelihood_;
  Snake snake_;
};

}  // namespace pellucida
