#pragma once
#include <cstddef>
#include <opencv2/core/mat.hpp>

#include "pellucida/core/ImageView.h"

namespace pellucida::test {

/// The pixels of a grey image, 8 or 16 bit, as a tracker takes them; valid while `grey` lives.
inline ImageView mat_view(const cv::Mat& grey, double pixel_size_um) {
  ImageView view;
  view.data = grey.data;
  view.format = grey.depth() == CV_16U ? PixelFormat::kGray16 : PixelFormat::kGray8;
  view.width_px = grey.cols;
  view.height_px = grey.rows;
  view.row_bytes = static_cast<std::ptrdiff_t>(grey.step[0]);
  view.pixel_size_um = pixel_size_um;
  return view;
}

}  // namespace pellucida::test
