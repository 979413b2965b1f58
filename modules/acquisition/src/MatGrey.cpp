#include "MatGrey.h"

#include <opencv2/imgproc.hpp>

#include "pellucida/core/Error.h"

namespace pellucida {

GreyImage grey_from_mat(const cv::Mat& pixels) {
  if (pixels.depth() != CV_8U || (pixels.channels() != 1 && pixels.channels() != 3)) {
    throw InputError("a video picture of a kind not known here; convert it to 8 bit grey or colour");
  }
  GreyImage image = make_grey(pixels.cols, pixels.rows, 8);
  cv::Mat grey(pixels.rows, pixels.cols, CV_8UC1, image.bytes.data());
  // OpenCV's own conversion has the same weights, and is vectorised.
  if (pixels.channels() == 3) {
    cv::cvtColor(pixels, grey, cv::COLOR_BGR2GRAY);
  } else {
    pixels.copyTo(grey);
  }
  return image;
}

}  // namespace pellucida
