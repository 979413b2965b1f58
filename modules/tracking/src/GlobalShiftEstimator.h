#pragma once
#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

#include "FrameSampler.h"

namespace pellucida {

/// Notices that the whole picture has jumped between two frames (a knock on the stage) and by how much, from sparse
/// copies of both: followers search near the last positions, and need to know when everything has moved.
class GlobalShiftEstimator {
 public:
  /// Compares with the frame before and remembers this one. The jump in px where there is one (above 3 px, up to a
  /// quarter of the image), good to about 4 px; nothing in an ordinary frame, at the first, or after a change of size.
  std::optional<Eigen::Vector2d> update(const FrameSampler& image);

  void reset() { usual_change_ = -1.0; }

 private:
  void thin_out(const FrameSampler& image);

  cv::Mat now_, before_, window_;  // float thumbnails; the window that fades their borders
  double usual_change_ = -1.0;     // running mean of the change from frame to frame; negative: no frame before
};

}  // namespace pellucida
