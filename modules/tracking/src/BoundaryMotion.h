#pragma once
#include <Eigen/Core>
#include <cstdint>

#include "CyclicBandSolver.h"
#include "FrameSampler.h"
#include "NeedleZone.h"
#include "NormalStrip.h"

namespace pellucida {

/// Where a boundary has gone since a network read it: the picture along its normals then, held against that of now. The
/// surroundings of each point move along its normal (least squares of place; B. Lucas and T. Kanade, 1981), all points
/// smoothly. What the boundary looks like does not matter, and nothing drifts, since every frame is held against the
/// one that was read. It costs about a fiftieth of what the network does.
class BoundaryMotion {
 public:
  /// The boundary as it was read on `image`: `points` (2 x n, px, closed, positive area, n >= 5).
  void set(const FrameSampler& image, const Eigen::Matrix2Xd& points);

  /// Finds it near `points` (2 x n), where the same points are expected now; `noise`: standard deviation of a pixel.
  /// What `needle` (may be null) covers moves as expected while it touches, and with its neighbours else. False, and it
  /// has to be read anew, where the picture is another than that which was read, has moved further than can be
  /// followed, or no boundary of so many points was read.
  bool find(const FrameSampler& image, const Eigen::Matrix2Xd& points, double noise, const NeedleZone* needle);

  /// After a `find` that has found it, (n) each: how far outwards of where it was expected it is, along `normals`, px,
  /// and the variance of that.
  const Eigen::VectorXd& shift_px() const noexcept { return shift_px_; }
  const Eigen::VectorXd& variance_px2() const noexcept { return variance_px2_; }
  const Eigen::Matrix2Xd& normals() const noexcept { return normals_; }

 private:
  enum class Place : std::uint8_t { kOpen, kBesideNeedle, kCovered };

  void sample(const FrameSampler& image, const Eigen::Matrix2Xd& points);
  void place_needle(const Eigen::Matrix2Xd& points, const NeedleZone* needle);
  bool settle(double pixel_variance, bool is_touched);
  bool is_alike(double pixel_variance) const;

  Eigen::Index rows_ = 0;
  double step_px_ = 0.5;
  // (taps x rows): the surroundings then, and their slopes; (rows) what noise of 1 leaves known of the place.
  Eigen::MatrixXf look_, slope_;
  Eigen::VectorXd information_;
  Eigen::VectorXd shift_px_, variance_px2_;

  // Scratch, kept from frame to frame.
  NormalStrip strip_;
  CyclicBandSolver solver_;
  Eigen::Matrix2Xd normals_;
  Eigen::VectorXd next_px_, misfit_, square_;
  Eigen::VectorXf seen_;
  Eigen::Array<Place, Eigen::Dynamic, 1> places_;
};

}  // namespace pellucida
