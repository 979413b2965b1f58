// Finding the cell in one image: with no hint, with a click, with a drawn outline; sizes; what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "CellDetector.h"
#include "CellFollower.h"
#include "RegionBorder.h"
#include "SceneVerdict.h"
#include "tracking/PixelView.h"

namespace pellucida {
namespace {

// A plain field with pixel noise, on which outlines are drawn.
class Field {
 public:
  Field(int width, int height, unsigned seed = 7) {
    image_.width = width;
    image_.height = height;
    image_.pixels.resize(static_cast<std::size_t>(width) * height);
    std::mt19937 random(seed);
    std::normal_distribution<float> noise(0.5F, 0.01F);
    for (float& p : image_.pixels) p = noise(random);
  }

  // A dark line of standard deviation `width_px` along a circle, over the angles where `drawn` says so.
  template <class Drawn>
  void add_line(const Eigen::Vector2d& center, double radius, double depth, double width_px, Drawn&& drawn) {
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x) {
        const Eigen::Vector2d d = Eigen::Vector2d(x, y) - center;
        const double off = (d.norm() - radius) / width_px;
        if (drawn(std::atan2(d.y(), d.x()))) add(x, y, -depth * std::exp(-0.5 * off * off));
      }
  }
  void add_line(const Eigen::Vector2d& center, double radius, double depth, double width_px = 1.5) {
    add_line(center, radius, depth, width_px, [](double) { return true; });
  }
  void add_ellipse(const Eigen::Vector2d& center, const Eigen::Vector2d& axes, double depth) {
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x) {
        const Eigen::Vector2d d = Eigen::Vector2d(x, y) - center, scaled = d.cwiseQuotient(axes);
        // Distance from the line, to first order.
        const double off = (scaled.norm() - 1.0) * scaled.norm() / (scaled.cwiseQuotient(axes).norm() + 1e-6) / 1.5;
        add(x, y, -depth * std::exp(-0.5 * off * off));
      }
  }
  // A disc brighter on one side and darker on the other, as oblique light shows a zona; soft edge.
  void add_relief_disc(const Eigen::Vector2d& center, double radius, double height, double blur_px) {
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x) {
        const Eigen::Vector2d d = Eigen::Vector2d(x, y) - center;
        const double inside = 1.0 / (1.0 + std::exp((d.norm() - radius) / blur_px));
        add(x, y, height * inside * d.x() / radius);
      }
  }
  void add_debris(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(0.0, 1.0);
    for (int k = 0; k < count; ++k) {
      // One draw a statement: compilers differ in the order of arguments.
      const double x = u(random) * image_.width;
      const double y = u(random) * image_.height;
      add_line({x, y}, 1.0 + 3.0 * u(random), 0.2, 1.2);
    }
  }
  const GrayImage& image() const { return image_; }

 private:
  void add(int x, int y, double value) {
    image_.pixels[static_cast<std::size_t>(y) * image_.width + x] += static_cast<float>(value);
  }
  GrayImage image_;
};

double mean_off(const Eigen::Matrix2Xd& points, const Eigen::Vector2d& center, double radius) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) sum += std::abs((points.col(i) - center).norm() - radius);
  return sum / static_cast<double>(points.cols());
}

Eigen::Matrix2Xd rough_circle(const Eigen::Vector2d& center, double radius, double error) {
  Eigen::Matrix2Xd points(2, 24);
  for (int i = 0; i < 24; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 24;
    points.col(i) =
        center + (radius + (i % 2 == 0 ? error : -error)) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return points;
}

class CellDiameter : public testing::TestWithParam<int> {};

TEST_P(CellDiameter, IsFoundAmongDebris) {
  const Eigen::Vector2d center(370.3, 240.8);
  const double radius = 0.5 * GetParam();
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Field field(728, 486, 7 + seed);
    field.add_debris(30, seed);
    field.add_line(center, radius, 0.2);
    const std::optional<DetectedCell> cell = detect_cell(field.image(), {});
    ASSERT_TRUE(cell) << "seed " << seed;
    // Near enough for the snakes, which settle it.
    EXPECT_LT((cell->circle.center - center).norm(), 3.0) << "seed " << seed;
    EXPECT_LT(mean_off(cell->outer.points, center, radius), 2.0) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Detection, CellDiameter, testing::Values(40, 60, 88, 130, 200, 300, 400));

TEST(Detection, DebrisAloneIsNoCell) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Field field(400, 300, seed);
    field.add_debris(60, seed);
    EXPECT_FALSE(detect_cell(field.image(), {})) << "seed " << seed;
  }
}

TEST(Detection, AClickChoosesBetweenTwoCells) {
  Field field(500, 300);
  const Eigen::Vector2d clear(130.0, 150.0), faint(350.0, 140.0);
  field.add_line(clear, 60.0, 0.25);
  field.add_line(faint, 52.0, 0.12);
  for (const auto& [click, center] :
       {std::pair{Eigen::Vector2d(115.0, 170.0), clear}, std::pair{Eigen::Vector2d(370.0, 120.0), faint}}) {
    DetectionHint hint;
    hint.inside = click;
    const std::optional<DetectedCell> cell = detect_cell(field.image(), {}, &hint);
    ASSERT_TRUE(cell);
    EXPECT_LT((cell->circle.center - center).norm(), 1.1);
  }
}

TEST(Detection, AClickBesideEveryCellFindsNone) {
  Field field(500, 300);
  field.add_line({130.0, 150.0}, 60.0, 0.25);
  DetectionHint hint;
  hint.inside = Eigen::Vector2d(400.0, 60.0);
  EXPECT_FALSE(detect_cell(field.image(), {}, &hint));
}

TEST(Detection, AnOutlineRescuesWhatDetectionRefuses) {
  // An elongated cell is not round enough for detection alone.
  Field field(400, 300);
  const Eigen::Vector2d center(200.0, 150.0), axes(110.0, 44.0);
  field.add_ellipse(center, axes, 0.15);
  ASSERT_FALSE(detect_cell(field.image(), {}));
  DetectionHint hint;
  hint.outline = rough_circle({0.0, 0.0}, 1.03, 0.05);
  hint.outline = (axes.asDiagonal() * hint.outline).colwise() + center;
  const std::optional<DetectedCell> cell = detect_cell(field.image(), {}, &hint);
  ASSERT_TRUE(cell);
  for (Eigen::Index i = 0; i < cell->outer.points.cols(); ++i) {
    const Eigen::Vector2d d = (cell->outer.points.col(i) - center).cwiseQuotient(axes);
    EXPECT_NEAR(d.norm(), 1.0, 0.06);
  }
}

TEST(Detection, AnOutlineRoundNothingIsRefused) {
  Field field(400, 300);
  DetectionHint hint;
  hint.outline = rough_circle({200.0, 150.0}, 72.0, 4.0);
  EXPECT_FALSE(detect_cell(field.image(), {}, &hint));
}

TEST(Detection, HighQualityFindsTheSameCell) {
  Field field(400, 300);
  const Eigen::Vector2d center(190.0, 160.0);
  field.add_line(center, 70.0, 0.2);
  TrackerOptions options;
  options.quality = TrackerOptions::Quality::kHigh;
  const std::optional<DetectedCell> cell = detect_cell(field.image(), options);
  ASSERT_TRUE(cell);
  EXPECT_LT(mean_off(cell->outer.points, center, 70.0), 1.0);
}

TEST(Detection, ASoftZonaOfBothSignsIsFoundRoundItsOolemma) {
  Field field(400, 360);
  const Eigen::Vector2d center(200.0, 180.0), zona_center(203.0, 178.0);
  field.add_relief_disc(zona_center, 125.0, 0.08, 2.0);
  field.add_line(center, 85.0, 0.25);
  const std::optional<DetectedCell> cell = detect_cell(field.image(), {});
  ASSERT_TRUE(cell);
  EXPECT_TRUE(cell->outer.is_border);
  ASSERT_TRUE(cell->inner);
  // Where the relief changes sign there is nothing to see: the mean counts.
  EXPECT_LT(mean_off(cell->outer.points, zona_center, 125.0), 3.0);
  const FoundEdge& oolemma = cell->oolemma ? *cell->oolemma : *cell->inner;
  EXPECT_LT(mean_off(oolemma.points, center, 85.0), 1.5);
}

// Its edge goes along with the oolemma that lines follow, and has no dimple.
TEST(Detection, LinesThatHaveASoftZonaAreJudgedSo) {
  const Eigen::Vector2d center(200.0, 180.0);
  SceneReader reader;
  for (const double relief : {0.08, 0.0}) {
    Field field(400, 360);
    field.add_relief_disc({203.0, 178.0}, 125.0, relief, 2.0);
    field.add_line(center, 85.0, 0.25);
    const std::optional<DetectedCell> cell = detect_cell(field.image(), {});
    ASSERT_TRUE(cell);
    std::vector<std::uint8_t> pixels;
    for (const float p : field.image().pixels)
      pixels.push_back(static_cast<std::uint8_t>(std::clamp(255.0F * p, 0.0F, 255.0F)));
    const ImageView view = test::view_of_bytes(pixels, 400, 360, 1.0);
    TrackerTimings timings;
    FrameInput frame{.view = view, .image = FrameSampler(view), .timings = &timings};
    frame.noise = noise_level(frame.image);
    CellFollower follower{TrackerOptions{}};
    ASSERT_TRUE(follower.start(frame, *cell));
    EXPECT_EQ(judge_lines(follower, {}, frame.image, reader).is_soft, relief > 0.0);
  }
}

TEST(Detection, ACellWithoutZonaGetsNone) {
  Field field(400, 360);
  field.add_line({200.0, 180.0}, 85.0, 0.25);
  const std::optional<DetectedCell> cell = detect_cell(field.image(), {});
  ASSERT_TRUE(cell);
  EXPECT_FALSE(cell->outer.is_border);
  EXPECT_FALSE(cell->oolemma);
}

TEST(RegionBorder, EvidenceIsWhereTextureChangesAtOneBrightness) {
  // Same mean, grain inside only.
  GrayImage image;
  image.width = image.height = 200;
  std::mt19937 random(5);
  std::normal_distribution<float> calm(0.5F, 0.01F), grain(0.5F, 0.05F);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      image.pixels.push_back(std::hypot(x - 100.0, y - 100.0) < 60.0 ? grain(random) : calm(random));
  const Eigen::Matrix2Xd circle = contour::resample(rough_circle({100.0, 100.0}, 60.0, 0.0), 120);
  RegionBorder border;
  border.sample(image, circle, contour::outward_normals(circle), 15.0, 15.0, 1.0, 8.0);
  Eigen::MatrixXf evidence;
  border.evidence(5, 0.001, evidence);
  const Eigen::VectorXf mean = evidence.colwise().mean();
  Eigen::Index best = 0;
  EXPECT_GT(mean.maxCoeff(&best), 0.5F);
  EXPECT_LT(mean[0], 0.1F);
  // Windows that move along lean towards the calm side; a split of fixed samples does not.
  Eigen::MatrixXf likelihood;
  border.split(std::vector<int>(120, 15), 6, 5, 0.001, likelihood);
  Eigen::Index place = 0;
  likelihood.colwise().mean().maxCoeff(&place);
  EXPECT_NEAR(static_cast<double>(place) - 6.0, 0.0, 1.01);
}

}  // namespace
}  // namespace pellucida
