// Images no microscope gives, and sequences of them: no crash, finite numbers, contours that do not cross themselves,
// and no confidence where there is no cell. The same sequences, driven by coverage: tracking_fuzzer.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "pellucida/tracking/MembraneTracker.h"
#include "tracking/FuzzSequence.h"
#include "tracking/ObservationChecks.h"

namespace pellucida {
namespace {

struct Size {
  int width_px, height_px;
};

class OddSizes : public testing::TestWithParam<Size> {};

TEST_P(OddSizes, AnyContentIsSurvivedAndNeverBelieved) {
  const Size size = GetParam();
  std::mt19937 random(31);
  for (int content = 0; content < test::kFuzzContents; ++content) {
    for (const PixelFormat format : {PixelFormat::kGray8, PixelFormat::kGray16}) {
      // Rows longer than the width, by an odd number of bytes.
      for (const int padding : {0, 5}) {
        std::array<std::uint8_t, 64> bytes;
        for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random());
        test::ByteReader choices(bytes.data(), bytes.size());
        const test::FuzzImage image = test::draw_fuzz_image(size.width_px, size.height_px, format, padding,
                                                            static_cast<test::FuzzContent>(content), choices);
        MembraneTracker tracker;
        for (int k = 0; k < 2; ++k) {
          const Observation seen = tracker.process(image.view, k / 30.0, k);
          EXPECT_EQ(test::violation_of(seen, image.view), "") << "content " << content << " padding " << padding;
          if (!image.shows_a_cell) {
            EXPECT_LE(seen.confidence, 0.8) << "content " << content << " padding " << padding;
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, OddSizes,
                         testing::Values(Size{1, 1}, Size{1, 37}, Size{37, 1}, Size{2, 2}, Size{7, 9}, Size{64, 2000},
                                         Size{2000, 64}, Size{128, 96}, Size{300, 301}),
                         [](const testing::TestParamInfo<Size>& chosen) {
                           return std::to_string(chosen.param.width_px) + "x" + std::to_string(chosen.param.height_px);
                         });

TEST(FuzzSequences, SizeFormatAndContentMayChangeFromFrameToFrame) {
  std::mt19937_64 random(7);
  for (int run = 0; run < 200; ++run) {
    std::array<std::uint8_t, 256> bytes;
    for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random() >> 20);
    EXPECT_EQ(test::run_fuzz_sequence(bytes.data(), bytes.size()), "") << "run " << run;
  }
}

TEST(FuzzSequences, ACellSeenInAnImageIsNotLookedForOutsideTheNextSmallerOne) {
  // Followed in a large picture, then one row, then large again.
  const std::array<std::uint8_t, 64> bytes{3, 128, 120, 120, 90, 20, 160, 10, 80, 200, 3, 5};
  MembraneTracker tracker;
  int k = 0;
  for (const Size size : {Size{300, 300}, Size{300, 300}, Size{300, 1}, Size{3, 300}, Size{300, 300}, Size{40, 40}}) {
    test::ByteReader choices(bytes.data(), bytes.size());
    const test::FuzzImage image =
        test::draw_fuzz_image(size.width_px, size.height_px, k % 2 ? PixelFormat::kGray16 : PixelFormat::kGray8, 0,
                              test::FuzzContent::kCell, choices);
    const Observation seen = tracker.process(image.view, k / 30.0, k);
    EXPECT_EQ(test::violation_of(seen, image.view), "") << "frame " << k;
    if (k == 0) {
      EXPECT_TRUE(seen.outer.has_value()) << "the drawn cell was not seen: the test would show nothing";
    }
    ++k;
  }
}

}  // namespace
}  // namespace pellucida
