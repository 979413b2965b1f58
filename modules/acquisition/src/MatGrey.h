#pragma once
#include <opencv2/core.hpp>

#include "Grey.h"

namespace pellucida {

/// An 8 bit OpenCV picture, grey or blue-green-red, as grey by the same luminance as everywhere here.
GreyImage grey_from_mat(const cv::Mat& pixels);

}  // namespace pellucida
