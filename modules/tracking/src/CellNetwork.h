#pragma once
#include <Eigen/Core>
#include <memory>

#include "FrameSampler.h"

namespace pellucida {

/// A small convolutional network that looks at what lies within and about a circle and says whether that is a cell
/// whose outer boundary the circle follows, in any contrast; not a bubble, its halo, a pipette's end or debris. Trained
/// by `resources/networks/train_cell.py` on drawn pictures of the tuning and wide families; run by OpenCV. The patch
/// and its mirror image are read, so that a mirrored film gives the same.
class CellNetwork {
 public:
  /// Reads `networks/cell.onnx` of the resources. Throws InputError when it can't be read.
  CellNetwork();
  ~CellNetwork();
  CellNetwork(CellNetwork&&) noexcept;
  CellNetwork& operator=(CellNetwork&&) noexcept;

  /// How probable a cell is, 0..1. `center` and `radius_px` (> 0): the circle, px.
  double read(const FrameSampler& image, const Eigen::Vector2d& center, double radius_px);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
