#pragma once
#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "FrameSampler.h"

namespace pellucida {

/// A rigid motion in the image plane: p -> pivot + shift + R(angle) (p - pivot), px; a positive angle turns +x to +y.
struct RigidMove {
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  double angle_rad = 0.0;
  Eigen::Vector2d pivot = Eigen::Vector2d::Zero();

  Eigen::Vector2d turn(const Eigen::Vector2d& v) const {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
  }
  Eigen::Vector2d apply(const Eigen::Vector2d& p) const { return pivot + shift + turn(p - pivot); }
  /// The inverse of `apply`.
  Eigen::Vector2d undo(const Eigen::Vector2d& p) const {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    const Eigen::Vector2d v = p - pivot - shift;
    return pivot + Eigen::Vector2d(c * v.x() + s * v.y(), c * v.y() - s * v.x());
  }
};

/// Follows a set of pixels that move together (the holding pipette) by least squares on their grey values, with gain
/// and offset free: separates a drift or a turn of the stage from a deformation of the cell. The reference's gradients
/// replace the image's (turned with the motion), so that a round costs one sample per pixel (after Hager and Belhumeur
/// 1998).
class RigidMotion {
 public:
  /// Chooses among `candidates` (px) the most informative ones of `image`, and keeps their look as the reference. Turns
  /// are measured about `pivot`. False when, with pixel noise of standard deviation `noise`, a shift could not be
  /// determined in every direction to 0.1 px; turns are followed only where the pixels determine them to 0.1 px at
  /// their farthest.
  bool learn(const FrameSampler& image, const std::vector<Eigen::Vector2d>& candidates, const Eigen::Vector2d& pivot,
             double noise);

  /// Finds the motion since `learn`, px; starts from the last one moved by `jump` (0, or what the whole picture seems
  /// to have jumped, good to a few px); where that fits unusually ill, beside it as well. `reach_px` bounds the step.
  /// False when the fit fails.
  bool track(const FrameSampler& image, double reach_px, const Eigen::Vector2d& jump);

  /// Something else says that the motion is about `shift`: taken where the pixels fit as well near there as at the last
  /// place.
  bool correct(const FrameSampler& image, const Eigen::Vector2d& shift);

  /// The next fit begins so much further; for motions along which the pixels tell nothing.
  void move_by(const Eigen::Vector2d& way) noexcept { motion_.shift += way; }

  const RigidMove& motion() const noexcept { return motion_; }
  /// Standard deviation of the shift along unit `direction`, px: as the pixels tell it, and by how much it has differed
  /// of late from a steady motion.
  double sigma_px(const Eigen::Vector2d& direction) const noexcept;
  bool valid() const noexcept { return !pixels_.empty(); }
  void reset();

 private:
  // A pixel of the reference: place about the pivot, gradient, what a turn by 1 rad changes, grey value.
  struct Pixel {
    Eigen::Vector2d place, gradient;
    double turn = 0.0, value = 0.0;
  };
  struct Fit {
    RigidMove move;
    double residual = 0.0;
    bool good = false;
  };
  /// From `start`; given up, and not good, as soon as it comes near to `known`.
  Fit refine(const FrameSampler& image, RigidMove start, const RigidMove* known = nullptr) const;
  void average_in(const FrameSampler& image);

  std::vector<Pixel> pixels_;
  double noise_ = 0.0;
  double spread_ = 0.0;      // standard deviation of the reference's grey values
  bool turns_ = false;       // whether the pixels determine a turn
  int frames_averaged_ = 1;  // in the reference's grey values
  int frames_followed_ = 0;
  double usual_residual_ = 0.0;
  Eigen::Vector2d velocity_ = Eigen::Vector2d::Zero();  // px a frame
  Eigen::Matrix2d unrest_ = Eigen::Matrix2d::Zero();    // px^2, covariance of a frame's place about that
  Eigen::Vector2d along_ = Eigen::Vector2d::UnitX();    // the direction in which the pixels tell least
  Eigen::Matrix2d shift_covariance_ = Eigen::Matrix2d::Zero();
  RigidMove motion_;
};

}  // namespace pellucida
