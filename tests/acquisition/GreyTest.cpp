#include "Grey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "MatGrey.h"

namespace pellucida {
namespace {

TEST(Grey, EqualChannelsKeepTheirValue) {
  for (int value = 0; value < 65536; ++value) {
    const std::uint16_t colour[4] = {static_cast<std::uint16_t>(value), static_cast<std::uint16_t>(value),
                                     static_cast<std::uint16_t>(value), 7};
    std::uint16_t grey = 0;
    to_grey(colour, 4, 2, 1, &grey);
    ASSERT_EQ(grey, value);
  }
}

TEST(Grey, ColourBecomesLuminance) {
  const std::uint8_t colours[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 10, 200, 30};
  std::uint8_t grey[4];
  to_grey(colours, 3, 1, 4, grey);
  EXPECT_EQ(grey[0], std::lround(0.299 * 255));
  EXPECT_EQ(grey[1], std::lround(0.587 * 255));
  EXPECT_EQ(grey[2], std::lround(0.114 * 255));
  EXPECT_EQ(grey[3], std::lround(0.299 * 10 + 0.587 * 200 + 0.114 * 30));
}

TEST(Grey, AlphaIsLeftOut) {
  const std::uint8_t grey_alpha[] = {9, 255, 8, 0};
  std::uint8_t grey[2];
  to_grey(grey_alpha, 2, 1, 2, grey);
  EXPECT_EQ(grey[0], 9);
  EXPECT_EQ(grey[1], 8);
}

// Video and stills must agree: the two conversions differ by rounding at most.
TEST(Grey, VideoHasTheSameLuminance) {
  cv::Mat colours(1, 4096, CV_8UC3);
  cv::RNG random(7);
  random.fill(colours, cv::RNG::UNIFORM, 0, 256);
  cv::Mat swapped;
  cv::cvtColor(colours, swapped, cv::COLOR_BGR2RGB);
  const GreyImage video = grey_from_mat(colours);
  std::vector<std::uint8_t> still(4096);
  to_grey(swapped.data, 3, 1, still.size(), still.data());
  for (std::size_t i = 0; i < still.size(); ++i) ASSERT_NEAR(video.bytes[i], still[i], 1) << i;
}

}  // namespace
}  // namespace pellucida
