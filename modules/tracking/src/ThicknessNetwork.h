#pragma once
#include <Eigen/Core>
#include <memory>

#include "FrameSampler.h"

namespace pellucida {

/// How thick a zona pellucida is, as a network sees it.
struct ThicknessReading {
  double thickness_px = 0.0;
  double log_sigma = 0.0;  ///< standard deviation of its logarithm, as spread as the network's answer is
};

/// A small convolutional network that reads the ring of an image along a cell's outer boundary and says how thick the
/// zona pellucida is, in any contrast, from all sides of the cell at once, where the boundary network says it of each
/// normal. Trained by `resources/networks/train_thickness.py` on drawn pictures of the tuning families; run by OpenCV.
/// It sees as far as 1.4 of the supposed thickness outside the outline and 3.1 inside.
class ThicknessNetwork {
 public:
  /// Reads `networks/thickness.onnx` of the resources. Throws InputError when it can't be read.
  ThicknessNetwork();
  ~ThicknessNetwork();
  ThicknessNetwork(ThicknessNetwork&&) noexcept;
  ThicknessNetwork& operator=(ThicknessNetwork&&) noexcept;

  /// Reads along `outline` (2 x n, px, closed, positive area, 3 points or more), which lies on the outer boundary.
  /// `supposed_px`: what the thickness is taken for, above 0; where it turns out otherwise it is read again from there.
  ThicknessReading read(const FrameSampler& image, const Eigen::Matrix2Xd& outline, double supposed_px);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
