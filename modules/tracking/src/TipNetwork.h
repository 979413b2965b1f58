#pragma once
#include <Eigen/Core>
#include <memory>

#include "FrameSampler.h"
#include "NeedleModel.h"

namespace pellucida {

/// Where a needle ends.
struct TipReading {
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();  ///< px
  double along_sigma_px = 0.0;                    ///< standard deviation of the network's answer along the needle
  double share = 0.0;                             ///< 0..1: of the answer, near its highest place
};

/// A small convolutional network that reads the patch of an image about the supposed tip of a needle, laid along it,
/// and says where in it the tip is, in any contrast and whatever lies before it. Trained by
/// `resources/networks/train_tip.py` on drawn pictures of the tuning families; run by OpenCV. It sees 56 samples behind
/// the supposed tip and 39 ahead of it, five of which make the needle's half width. A second network of the same make,
/// with twelve samples to the half width, says where in that a needle 8 px wide and more ends. A third one, a tenth as
/// large, looks no farther than 40 samples behind and 23 ahead, eight to the half width: for the frames between.
class TipNetwork {
 public:
  /// Reads `networks/tip.onnx` and `tip_fine.onnx` of the resources. Throws InputError when they can't be read.
  TipNetwork();
  ~TipNetwork();
  TipNetwork(TipNetwork&&) noexcept;
  TipNetwork& operator=(TipNetwork&&) noexcept;

  /// Reads about the axis's tip, and where that points beyond what it saw, from there; `half_width_px`: the needle's,
  /// some way behind its tip. The share is 0 where no end comes into view.
  TipReading read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px);
  /// The same for a needle found just now: looks from farther behind where the tip isn't seen, and whether the needle
  /// goes on where something else looks like its end, but no farther than beside `last`, px.
  TipReading find(const FrameSampler& image, const NeedleAxis& axis, double half_width_px, const Eigen::Vector2d& last);
  /// Reads by the small network: a tip known to within a few samples. It is as precise once what it is off by on this
  /// needle is known. The share is 0 where no end is in view.
  TipReading read_quickly(const FrameSampler& image, const NeedleAxis& axis, double half_width_px);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
