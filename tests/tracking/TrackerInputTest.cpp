#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "PixelView.h"
#include "pellucida/core/Error.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida {
namespace {

constexpr double kPixelSize_um = 0.5;

ImageView view_of_bytes(const std::vector<std::uint8_t>& pixels, int width, int height) {
  return test::view_of_bytes(pixels, width, height, kPixelSize_um);
}

TEST(TrackerInput, BadImagesAreRefusedWithTheReason) {
  MembraneTracker tracker;
  const std::vector<std::uint8_t> pixels(100 * 80, 120);
  const ImageView good = view_of_bytes(pixels, 100, 80);
  EXPECT_NO_THROW(tracker.process(good, 0.0, 0));

  ImageView bad = good;
  bad.data = nullptr;
  EXPECT_THROW(tracker.process(bad, 0.0, 0), UsageError);
  bad = good;
  bad.width_px = 0;
  EXPECT_THROW(tracker.process(bad, 0.0, 0), UsageError);
  bad = good;
  bad.row_bytes = 99;
  EXPECT_THROW(tracker.process(bad, 0.0, 0), UsageError);
  for (const double size :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    bad = good;
    bad.pixel_size_um = size;
    EXPECT_THROW(tracker.process(bad, 0.0, 0), UsageError) << size;
  }
}

TEST(TrackerInput, BadOptionsNameTheOption) {
  TrackerOptions options;
  options.contour_point_count = 3;
  try {
    MembraneTracker tracker(options);
    FAIL() << "3 contour points were accepted";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("contour_point_count"), std::string::npos) << error.what();
  }
}

TEST(TrackerInput, ImagesOfAnySizeAndContentDoNotCrash) {
  std::mt19937 random(21);
  std::uniform_int_distribution<int> side(1, 150), value(0, 255), kind(0, 4);
  for (int k = 0; k < 60; ++k) {
    MembraneTracker tracker;
    const int width = side(random), height = side(random), what = kind(random);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) * height);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const int x = static_cast<int>(i) % width;
      pixels[i] = static_cast<std::uint8_t>(what == 0   ? 0
                                            : what == 1 ? 255
                                            : what == 2 ? value(random)
                                            : what == 3 ? (x % 7) * 36
                                                        : (i % 2) * 255);
    }
    // The same tracker sees images of two sizes: nothing may be kept that no longer fits.
    const Observation first = tracker.process(view_of_bytes(pixels, width, height), 0.0, 0);
    EXPECT_LE(first.confidence, 0.8) << width << " x " << height << " kind " << what;
    tracker.process(view_of_bytes(pixels, std::max(1, width / 2), height), 0.1, 1);
  }
}

TEST(TrackerInput, AnOutlineOfAnySizeDoesNotCrash) {
  const std::vector<std::uint8_t> pixels(100 * 80, 120);
  for (const double radius_um : {0.0, 1e-200, 1e3, 1e9, 1e160, 1e300}) {
    MembraneTracker tracker;
    CellHint hint;
    hint.outline_um = Contour_um(2, 4);
    *hint.outline_um << 0.0, radius_um, 0.0, -radius_um, radius_um, 0.0, -radius_um, 0.0;
    tracker.expect_cell(hint);
    EXPECT_EQ(tracker.process(view_of_bytes(pixels, 100, 80), 0.0, 0).state, CellState::kNoCell) << radius_um;
  }
}

TEST(TrackerInput, NoiseAndEmptyFieldsAreNoCell) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(130.0, 8.0);
  for (int k = 0; k < 5; ++k) {
    MembraneTracker tracker;
    std::vector<std::uint8_t> pixels(400 * 300);
    for (std::uint8_t& p : pixels) p = static_cast<std::uint8_t>(std::clamp(noise(random), 0.0, 255.0));
    const Observation seen = tracker.process(view_of_bytes(pixels, 400, 300), 0.0, 0);
    EXPECT_EQ(seen.state, CellState::kNoCell);
    EXPECT_EQ(seen.confidence, 0.0);
    EXPECT_FALSE(seen.outer.has_value());
  }
}

}  // namespace
}  // namespace pellucida
