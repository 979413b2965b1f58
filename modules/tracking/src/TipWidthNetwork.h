#pragma once
#include <memory>

#include "FrameSampler.h"
#include "NeedleModel.h"

namespace pellucida {

/// How wide a needle is at its tip.
struct TipWidthReading {
  double radius_px = 0.0;  ///< half the width
  double sigma = 0.0;      ///< standard deviation of its logarithm, as the network itself judges it
};

/// A small convolutional network that reads the patch of an image about a needle's tip, laid along it, and says how
/// wide the glass is there, in any contrast: lines and flanks lie inside or outside an outline by what the optics make
/// of it. Trained by `resources/networks/train_tip_width.py` on drawn pictures of the tuning families; run by OpenCV.
/// The patch and its mirror image are read, so that a mirrored film gives the same.
class TipWidthNetwork {
 public:
  /// Reads `networks/tip_width.onnx` of the resources. Throws InputError when it can't be read.
  TipWidthNetwork();
  ~TipWidthNetwork();
  TipWidthNetwork(TipWidthNetwork&&) noexcept;
  TipWidthNetwork& operator=(TipWidthNetwork&&) noexcept;

  /// Reads about the axis's tip; `half_width_px`: the needle's, some way behind its tip.
  TipWidthReading read(const FrameSampler& image, const NeedleAxis& axis, double half_width_px);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
