#pragma once
#include <opencv2/core.hpp>
#include <vector>

#include "pellucida/core/ImageView.h"
#include "pellucida/microscopy/Look.h"
#include "pellucida/microscopy/SeededNumbers.h"

namespace pellucida {

/// Turns light into grey values as a camera does: field of light and dust, shot and read noise, fixed pattern,
/// automatic exposure, gamma, interlace, sharpening, JPEG.
class CameraModel {
 public:
  /// Throws UsageError: JPEG with 16 bit.
  CameraModel(const Look::Camera& look, const ImageView& image, std::uint64_t seed);

  /// The grey values (CV_8U or CV_16U), valid until the next call. `light` relative to the empty field.
  const cv::Mat& expose(const cv::Mat1f& light, long frame_index, double time_s, double lamp_ratio);

 private:
  template <class Pixel>
  void count(const cv::Mat1f& light, long frame_index, float lamp);

  Look::Camera look_;
  NoiseBank noise_;
  cv::Mat1f field_;    // ratio of full scale
  cv::Mat1f pattern_;  // added, of full scale
  std::vector<float> counted_, gamma_;
  cv::Mat frame_, before_, soft_;
  std::vector<unsigned char> jpeg_;
};

}  // namespace pellucida
