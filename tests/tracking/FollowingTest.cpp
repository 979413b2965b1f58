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

struct Line {
  double radius_px, depth;
};

// A cell of dark lines in pixel noise.
std::vector<std::uint8_t> cell(const std::vector<Line>& lines, unsigned seed, double right_px = 0.0) {
  std::vector<std::uint8_t> pixels(kCellWidth_px * kCellHeight_px);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.5);
  for (int y = 0; y < kCellHeight_px; ++y)
    for (int x = 0; x < kCellWidth_px; ++x) {
      const double r = std::hypot(x - 160.3 - right_px, y - 149.6);
      double grey = 140.0 + noise(random);
      for (const Line& line : lines) {
        const double off = (r - line.radius_px) / 1.5;
        grey -= line.depth * std::exp(-0.5 * off * off);
      }
      pixels[static_cast<std::size_t>(y * kCellWidth_px + x)] = static_cast<std::uint8_t>(grey + 0.5);
    }
  return pixels;
}

double radius_um(const MembraneContour& contour) {
  return std::sqrt(std::abs(contour::signed_area(contour.points_um)) / std::numbers::pi);
}

TEST(Following, AContourDoesNotJumpToAnEdgeWithin) {
  TrackerOptions options;
  options.detection = TrackerOptions::Detection::kLines;
  MembraneTracker tracker(options);
  bool was_followed = false;
  for (int k = 0; k < 10; ++k) {  // then it is lost, and the edge within may be found anew
    const std::vector<std::uint8_t> pixels =
        cell({{kOuter_px, k < 8 ? 60.0 : 10.0}, {kInner_px, 60.0}}, 11U + static_cast<unsigned>(k));
    const Observation seen =
        tracker.process(test::view_of_bytes(pixels, kCellWidth_px, kCellHeight_px, 1.0), 0.04 * k, k);
    if (k < 8) {
      was_followed = seen.outer.has_value();
      continue;
    }
    if (!seen.outer) continue;
    EXPECT_GT(radius_um(*seen.outer), 0.5 * (kOuter_px + kInner_px))
        << "frame " << k << ", confidence " << seen.confidence;
  }
  EXPECT_TRUE(was_followed);
}

// A zona does not become half as thick again between two frames, however dark the oolemma within it is and although the
// cell moved.
TEST(Following, TheZonasInnerEdgeDoesNotGoOverToTheOolemma) {
  constexpr double kZonaInner_px = 76.0, kOolemma_px = 70.0;
  TrackerOptions options;
  options.detection = TrackerOptions::Detection::kLines;
  MembraneTracker tracker(options);
  for (int k = 0; k < 8; ++k) {
    const bool has_moved = k >= 4;
    const std::vector<std::uint8_t> pixels =
        cell({{kOuter_px, 60.0}, {kZonaInner_px, has_moved ? 50.0 : 60.0}, {kOolemma_px, has_moved ? 75.0 : 60.0}},
             21U + static_cast<unsigned>(k), has_moved ? 5.0 : 0.0);
    const Observation seen =
        tracker.process(test::view_of_bytes(pixels, kCellWidth_px, kCellHeight_px, 1.0), 0.04 * k, k);
    ASSERT_TRUE(seen.outer && seen.inner) << "frame " << k;
    EXPECT_NEAR(radius_um(*seen.outer), kOuter_px, 0.5) << "frame " << k;
    EXPECT_NEAR(radius_um(*seen.inner), kZonaInner_px, 0.5) << "frame " << k;
    EXPECT_GT(seen.confidence, 0.9) << "frame " << k;
  }
}

// A ring far from the size of the kind is a bubble's, unless a person says that it is a cell.
TEST(Following, ARingFarFromTheSizeOfTheKindIsNoCell) {
  const std::vector<std::uint8_t> pixels = cell({{kOuter_px, 60.0}, {kInner_px, 60.0}}, 5U);
  const auto sees_cell = [&](double expected_radius_um, bool is_clicked) {
    TrackerOptions options;
    options.detection = TrackerOptions::Detection::kLines;
    options.expected_radius_um = expected_radius_um;
    MembraneTracker tracker(options);
    if (is_clicked) tracker.expect_cell({.inside_um = Eigen::Vector2d(80.0, 75.0), .outline_um = std::nullopt});
    return tracker.process(test::view_of_bytes(pixels, kCellWidth_px, kCellHeight_px, 0.5), 0.0, 0).outer.has_value();
  };
  const double ring_um = 0.5 * kOuter_px;
  for (const double expected_um : {0.0, ring_um, 2.0 * ring_um, 0.5 * ring_um})
    EXPECT_TRUE(sees_cell(expected_um, false)) << expected_um;
  for (const double expected_um : {2.7 * ring_um, 0.3 * ring_um})
    EXPECT_FALSE(sees_cell(expected_um, false)) << expected_um;
  EXPECT_TRUE(sees_cell(2.7 * ring_um, true));
}

}  // namespace
}  // namespace pellucida
