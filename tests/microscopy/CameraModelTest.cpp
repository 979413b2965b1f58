#include "CameraModel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

ImageView format(PixelFormat pixel) {
  ImageView view;
  view.format = pixel;
  view.width_px = 320;
  view.height_px = 240;
  view.pixel_size_um = 1;
  return view;
}

Look::Camera plain() {
  Look::Camera look;
  look.gradient_ratio = look.vignette_ratio = look.fixed_pattern_ratio = 0;
  look.dust_count = 0;
  return look;
}

TEST(CameraModel, NoiseIsShotAndReadNoise) {
  Look::Camera look = plain();
  look.full_well_electrons = 4000;
  look.read_noise_electrons = 30;
  CameraModel camera(look, format(PixelFormat::kGray16), 3);
  const cv::Mat1f light(240, 320, 1.0f);
  cv::Scalar mean, deviation;
  cv::meanStdDev(camera.expose(light, 0, 0, 1), mean, deviation);
  const double electrons = 0.55 * 4000;
  EXPECT_NEAR(mean[0] / 65535, 0.55, 0.001);
  EXPECT_NEAR(deviation[0] / 65535 * 4000, std::sqrt(electrons + 900), 1);
}

TEST(CameraModel, GammaKeepsTheLevelAndExposureSteps) {
  Look::Camera look = plain();
  look.gamma = 0.45;
  look.exposure_step_ratio = 0.3;
  CameraModel camera(look, format(PixelFormat::kGray8), 3);
  const cv::Mat1f light(240, 320, 1.0f);
  EXPECT_NEAR(cv::mean(camera.expose(light, 0, 0.0, 1))[0] / 255, 0.55, 0.01);
  EXPECT_NEAR(cv::mean(camera.expose(light, 1, 1.2, 1))[0] / 255, 0.55 * std::pow(1.3, 0.45), 0.01);
}

TEST(CameraModel, InterlaceShowsTheFrameBefore) {
  Look::Camera look = plain();
  look.interlaced = true;
  CameraModel camera(look, format(PixelFormat::kGray8), 3);
  camera.expose(cv::Mat1f(240, 320, 0.5f), 0, 0, 1);
  const cv::Mat second = camera.expose(cv::Mat1f(240, 320, 1.5f), 1, 0.03, 1);
  EXPECT_GT(cv::mean(second.row(100))[0], 190);
  EXPECT_LT(cv::mean(second.row(101))[0], 90);
}

TEST(CameraModel, JpegLeavesBlocksAndNeedsEightBits) {
  Look::Camera look = plain();
  look.jpeg_quality = 20;
  EXPECT_THROW(CameraModel(look, format(PixelFormat::kGray16), 3), UsageError);
  CameraModel camera(look, format(PixelFormat::kGray8), 3);
  const cv::Mat grey = camera.expose(cv::Mat1f(240, 320, 1.0f), 0, 0, 1);
  ASSERT_EQ(grey.size(), cv::Size(320, 240));
  // Steps between columns are larger at the blocks' borders.
  double at_border = 0, inside = 0;
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 1; x < grey.cols; ++x)
      (x % 8 == 0 ? at_border : inside) += std::abs(grey.at<uchar>(y, x) - grey.at<uchar>(y, x - 1));
  EXPECT_GT(at_border / (grey.cols / 8 - 1), 2 * inside / (grey.cols - grey.cols / 8));
}

}  // namespace
}  // namespace pellucida
