#pragma once
#include <Eigen/Core>
#include <memory>

#include "FrameSampler.h"
#include "NeedleModel.h"

namespace pellucida {

/// A small convolutional network that reads the patch of an image about a needle's tip that is past a cell's resting
/// outline, laid along the needle, and says where the membrane crosses the needle, in any contrast: at the tip while
/// the needle pushes it in, nearer to the resting outline once it has given way. Trained by
/// `resources/networks/train_puncture.py` on drawn pictures of the tuning families; run by OpenCV. It sees 40 samples
/// behind the tip and 24 ahead of it, 16 of which make the tip's depth.
class PunctureNetwork {
 public:
  /// A membrane nearer to the tip than this, of the tip's depth, is pushed by it.
  static constexpr double kLeastPushed_ratio = 0.8;
  /// Shallower tips, px, are not read.
  static constexpr double kLeastDepth_px = 1.5;

  /// Reads `networks/puncture.onnx` of the resources. Throws InputError when it can't be read.
  PunctureNetwork();
  ~PunctureNetwork();
  PunctureNetwork(PunctureNetwork&&) noexcept;
  PunctureNetwork& operator=(PunctureNetwork&&) noexcept;

  /// How likely the needle is through the membrane, 0..1: that this lies nearer to the resting outline than
  /// `kLeastPushed_ratio` says. Reads about the axis's tip, `depth_px` past the resting outline along the axis;
  /// `center`: of the cell at rest, px.
  double read(const FrameSampler& image, const NeedleAxis& axis, double depth_px, const Eigen::Vector2d& center);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
