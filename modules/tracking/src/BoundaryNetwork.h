#pragma once
#include <Eigen/Core>
#include <memory>

#include "FrameSampler.h"

namespace pellucida {

/// Where a boundary lies on the normals of an outline.
struct BoundaryPlaces {
  Eigen::VectorXd offset_px;  ///< (n) outwards from the outline, along its normals
  Eigen::VectorXd sigma_px;   ///< (n) as spread as the network's answer is
};

/// 0..1 for each place of that spread, on a cell of this radius.
Eigen::VectorXd confidence_of(const Eigen::VectorXd& sigma_px, double radius_px);

/// What the network sees around an outline.
struct BoundaryReading {
  Eigen::Matrix2Xd points;   ///< (2 x n) px: the outline, evenly spaced
  Eigen::Matrix2Xd normals;  ///< (2 x n) unit, outwards
  BoundaryPlaces outer;      ///< the zona's outer boundary
  BoundaryPlaces inner;      ///< the zona's inner boundary
};

/// A small convolutional network that reads the strip of normals along a rough outline of a cell and says on each
/// normal where the zona's outer and inner boundaries lie, in any contrast: the boundary as geometry, whatever the
/// optics make of it. Trained by `resources/networks/train_boundary.py` on drawn pictures of the tuning families; run
/// by OpenCV. It sees from 0.36 radii inside the outline to 0.23 radii outside.
class BoundaryNetwork {
 public:
  /// Reads `networks/boundary.onnx` of the resources. Throws InputError when it can't be read.
  BoundaryNetwork();
  ~BoundaryNetwork();
  BoundaryNetwork(BoundaryNetwork&&) noexcept;
  BoundaryNetwork& operator=(BoundaryNetwork&&) noexcept;

  /// Reads around `outline` (px, closed, positive area, 3 points or more).
  BoundaryReading read(const FrameSampler& image, const Eigen::Matrix2Xd& outline);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
