// A film is laid the same way round whatever way it came, and what is seen is told in the picture as it came.
#include "PictureOrientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <utility>

#include "pellucida/core/ImageView.h"
#include "pellucida/core/Observation.h"
#include "support/MatView.h"

namespace pellucida {
namespace {

constexpr double kPixel_um = 0.5;

ImageView view_of(const cv::Mat& image) {
  return test::mat_view(image, kPixel_um);
}

// Noise, with more of it in one corner.
cv::Mat picture(int width_px, int height_px, int depth) {
  cv::Mat image(height_px, width_px, depth);
  cv::RNG dice(7);
  dice.fill(image, cv::RNG::UNIFORM, 90, 110);
  cv::Mat corner = image(cv::Rect(width_px / 2, 2, width_px / 3, height_px / 4));
  dice.fill(corner, cv::RNG::UNIFORM, 0, 250);
  return image;
}

// Flipped along x with bit 1 of `version`, along y with bit 2, transposed with bit 4.
cv::Mat version_of(const cv::Mat& image, int version) {
  cv::Mat out = image.clone();
  if (version & 1) cv::flip(out, out, 1);
  if (version & 2) cv::flip(out, out, 0);
  if (version & 4) out = out.t();
  return out;
}

struct Size {
  int width_px, height_px, depth;
};

class PictureOrientationTest : public ::testing::TestWithParam<Size> {};

TEST_P(PictureOrientationTest, AllEightVersionsAreLaidAlike) {
  const cv::Mat image = picture(GetParam().width_px, GetParam().height_px, GetParam().depth);
  cv::Mat first;
  for (int version = 0; version < 8; ++version) {
    SCOPED_TRACE(version);
    const cv::Mat shown = version_of(image, version);
    PictureOrientation orientation;
    orientation.choose(view_of(shown));
    const ImageView laid = orientation.lay(view_of(shown));
    const cv::Mat as_laid(laid.height_px, laid.width_px, GetParam().depth, const_cast<void*>(laid.data),
                          static_cast<std::size_t>(laid.row_bytes));
    if (version == 0) first = as_laid.clone();
    ASSERT_EQ(as_laid.size(), first.size());
    EXPECT_EQ(cv::norm(as_laid, first, cv::NORM_INF), 0.0);
  }
}

TEST_P(PictureOrientationTest, WhatIsSeenIsToldInThePictureAsItCame) {
  const cv::Mat image = picture(GetParam().width_px, GetParam().height_px, GetParam().depth);
  for (int version = 0; version < 8; ++version) {
    SCOPED_TRACE(version);
    const cv::Mat shown = version_of(image, version);
    PictureOrientation orientation;
    orientation.choose(view_of(shown));
    orientation.lay(view_of(shown));

    // A triangle of positive area round a centre, a needle, a rotation.
    Contour_um triangle(2, 3);
    triangle << 1, 4, 2, 1, 2, 6;
    const Eigen::Vector2d tip(7, 3), direction(0.6, 0.8);
    Observation seen;
    seen.outer.emplace();
    seen.outer->points_um = orientation.laid_points(triangle);
    seen.outer->sigma_um = Eigen::Vector3d(1, 2, 3);
    seen.outer->confidence = Eigen::Vector3d(0.1, 0.2, 0.3);
    const auto area = [](const Contour_um& p) {
      return (p(0, 1) - p(0, 0)) * (p(1, 2) - p(1, 0)) - (p(0, 2) - p(0, 0)) * (p(1, 1) - p(1, 0));
    };
    const bool is_mirrored = area(seen.outer->points_um) < 0.0;
    if (is_mirrored) {
      // As a tracker gives it: positive area in the picture that is laid.
      seen.outer->points_um.col(1).swap(seen.outer->points_um.col(2));
      std::swap(seen.outer->sigma_um[1], seen.outer->sigma_um[2]);
      std::swap(seen.outer->confidence[1], seen.outer->confidence[2]);
    }
    seen.needle.emplace();
    seen.needle->tip_um = orientation.laid_point(tip);
    seen.needle->direction = orientation.laid_direction(direction);
    seen.rotation_rad = is_mirrored ? -0.25 : 0.25;
    orientation.take_back(seen);

    EXPECT_TRUE(seen.outer->points_um.isApprox(triangle));
    EXPECT_EQ(seen.outer->sigma_um, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(seen.outer->confidence, Eigen::Vector3d(0.1, 0.2, 0.3));
    EXPECT_TRUE(seen.needle->tip_um.isApprox(tip));
    EXPECT_TRUE(seen.needle->direction.isApprox(direction));
    EXPECT_EQ(seen.rotation_rad, 0.25);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, PictureOrientationTest,
                         ::testing::Values(Size{61, 40, CV_8U}, Size{48, 48, CV_8U}, Size{33, 70, CV_16U}));

// A place that is pointed at lies where its pixel is laid.
TEST(PictureOrientation, APointIsLaidWithItsPixel) {
  cv::Mat image = picture(61, 40, CV_8U);
  image.at<std::uint8_t>(11, 5) = 255;
  for (int version = 0; version < 8; ++version) {
    const cv::Mat shown = version_of(image, version);
    cv::Point place;
    cv::minMaxLoc(shown, nullptr, nullptr, nullptr, &place);
    PictureOrientation orientation;
    orientation.choose(view_of(shown));
    const ImageView laid = orientation.lay(view_of(shown));
    const Eigen::Vector2d at = orientation.laid_point(kPixel_um * Eigen::Vector2d(place.x, place.y)) / kPixel_um;
    const auto* row = static_cast<const std::uint8_t*>(laid.data) + std::lround(at.y()) * laid.row_bytes;
    EXPECT_EQ(row[std::lround(at.x())], 255);
  }
}

// A picture smaller than its edges' neighbourhood has no balance, and is laid as it is.
TEST(PictureOrientation, ASinglePixelIsAPicture) {
  const cv::Mat image(1, 1, CV_8U, cv::Scalar(9));
  PictureOrientation orientation;
  orientation.choose(view_of(image));
  EXPECT_EQ(orientation.lay(view_of(image)).data, image.data);
}

}  // namespace
}  // namespace pellucida
