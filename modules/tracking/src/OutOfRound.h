#pragma once
#include <Eigen/Core>

#include "ContourMath.h"

namespace pellucida {

/// How far an outline at rest lies beyond its circle, by the direction from the centre: the second to fourth harmonics,
/// px. An oval cell's is the second; one drawn into its holder has all three.
class OutOfRound {
 public:
  struct Fit;
  /// Of an outline (2 x n, n >= 24) about a circle near it, by least squares whose weights fall off with the distance
  /// from the fit (a tenth of the outline that lies elsewhere still moves it by a quarter of that). A circle that has
  /// settled on one side of an oval moves to its middle, in `moves` steps at most. No shape where the outline is
  /// farther from round than a cell is (`kMost_ratio` of the radius).
  static Fit fit(const Eigen::Matrix2Xd& outline, const contour::Circle& circle, int moves = kMoves);
  /// The shape of that alone.
  static OutOfRound of(const Eigen::Matrix2Xd& outline, const contour::Circle& circle);

  /// Beyond the circle along `outward` (unit), px, in a cell that has turned by `angle_rad` since it was learnt.
  double at(const Eigen::Vector2d& outward, double angle_rad = 0.0) const;
  /// Those points moved along their rays by what lies beyond the circle, about `center`: a round cell's outline.
  Eigen::Matrix2Xd rounded(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& center) const;
  /// How far each point of an outline bulges out of the circle with these harmonics, px: as cells that lie on the zona
  /// make it seem to. 0 where that is over a large part of it.
  static Eigen::VectorXd bumps(const Eigen::Matrix2Xd& outline, const contour::Circle& circle);
  /// As it was before the cell turned by `angle_rad`.
  OutOfRound turned_back(double angle_rad) const;
  /// Moves towards another by a share.
  void mix(const OutOfRound& other, double share) { terms_ += share * (other.terms_ - terms_); }

  static constexpr int kLowest = 2, kHighest = 4;  ///< harmonics
  static constexpr int kMoves = 4;
  static constexpr double kMost_ratio = 0.15;
  static constexpr double kBump_ratio = 0.04;  ///< of the radius: what bulges out so far is no part of the outline

 private:
  // Cosine and sine of each.
  Eigen::Matrix<double, 2, kHighest - kLowest + 1> terms_ = Eigen::Matrix<double, 2, kHighest - kLowest + 1>::Zero();
};

struct OutOfRound::Fit {
  contour::Circle circle;
  OutOfRound shape;
  double misfit_px = 0.0;  ///< RMS distance of the outline from both
};

}  // namespace pellucida
