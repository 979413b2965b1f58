#pragma once
#include <opencv2/core.hpp>

#include "pellucida/core/Observation.h"

namespace pellucida {

/// Signed distance (um, positive outside) of the pixels of a window to a closed contour. Exact within `band_um` of the
/// contour, +-band beyond. `window`: part of the image, px. `distance_um` is (re)allocated to the window's size,
/// CV_32F.
void signed_distance(const Contour_um& contour_um, double pixel_size_um, const cv::Rect& window, double band_um,
                     cv::Mat1f& distance_um);

}  // namespace pellucida
