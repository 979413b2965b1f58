// What a contour may do from one frame to the next, on pictures drawn here.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "ContourMath.h"
#include "PixelView.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida {
namespace {

constexpr int kCellWidth_px = 320, kCellHeight_px = 300;
constexpr double kOuter_px = 90.0, kInner_px = 82.0;

// A cell of two dark lines, the outer one of any depth, in pixel noise.
std::vector<std::uint8_t> cell(double outer_depth, unsigned seed) {
  std::vector<std::uint8_t> pixels(kCellWidth_px * kCellHeight_px);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.5);
  for (int y = 0; y < kCellHeight_px; ++y)
    for (int x = 0; x < kCellWidth_px; ++x) {
      const double r = std::hypot(x - 160.3, y - 149.6);
      const auto line = [&](double radius, double depth) {
        const double off = (r - radius) / 1.5;
        return depth * std::exp(-0.5 * off * off);
      };
      pixels[static_cast<std::size_t>(y * kCellWidth_px + x)] =
          static_cast<std::uint8_t>(140.0 - line(kOuter_px, outer_depth) - line(kInner_px, 60.0) + noise(random) + 0.5);
    }
  return pixels;
}

TEST(Following, AContourDoesNotJumpToAnEdgeWithin) {
  TrackerOptions options;
  options.detection = TrackerOptions::Detection::kLines;
  MembraneTracker tracker(options);
  bool was_followed = false;
  for (int k = 0; k < 10; ++k) {  // then it is lost, and the edge within may be found anew
    const std::vector<std::uint8_t> pixels = cell(k < 8 ? 60.0 : 10.0, 11U + static_cast<unsigned>(k));
    const Observation seen =
        tracker.process(test::view_of_bytes(pixels, kCellWidth_px, kCellHeight_px, 1.0), 0.04 * k, k);
    if (k < 8) {
      was_followed = seen.outer.has_value();
      continue;
    }
    if (!seen.outer) continue;
    const double area = contour::signed_area(seen.outer->points_um);
    EXPECT_GT(std::sqrt(std::abs(area) / std::numbers::pi), 0.5 * (kOuter_px + kInner_px))
        << "frame " << k << ", confidence " << seen.confidence;
  }
  EXPECT_TRUE(was_followed);
}

// A ring far from the size of the kind is a bubble's, unless a person says that it is a cell.
TEST(Following, ARingFarFromTheSizeOfTheKindIsNoCell) {
  const std::vector<std::uint8_t> pixels = cell(60.0, 5U);
  const auto sees_cell = [&](double expected_radius_um, bool is_clicked) {
    TrackerOptions options;
    options.detection = TrackerOptions::Detection::kLines;
    options.expected_radius_um = expected_radius_um;
    MembraneTracker tracker(options);
    if (is_clicked) tracker.expect_cell({.inside_um = Eigen::Vector2d(80.0, 75.0), .outline_um = std::nullopt});
    return tracker.process(test::view_of_bytes(pixels, kCellWidth_px, kCellHeight_px, 0.5), 0.0, 0).outer.has_value();
  };
  const double radius_um = 0.5 * kOuter_px;
  for (const double expected_um : {0.0, radius_um, 2.0 * radius_um, 0.5 * radius_um})
    EXPECT_TRUE(sees_cell(expected_um, false)) << expected_um;
  for (const double expected_um : {2.7 * radius_um, 0.3 * radius_um})
    EXPECT_FALSE(sees_cell(expected_um, false)) << expected_um;
  EXPECT_TRUE(sees_cell(2.7 * radius_um, true));
}

}  // namespace
}  // namespace pellucida
