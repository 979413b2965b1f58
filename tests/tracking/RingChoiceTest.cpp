// A cell behind the one that lines find, where a needle points at it through that one and the scene shows none.
#include "RingChoice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "tracking/PixelView.h"

namespace pellucida {
namespace {

constexpr int kWidth_px = 520, kHeight_px = 300;
constexpr double kRadius_px = 60.0, kZona_px = 8.0;
const Eigen::Vector2d kFirst_px(150.0, 150.0), kSecond_px(330.0, 155.0);

// Cells on a bright field: the zona's two dark lines, and a darker ooplasm.
class Picture {
 public:
  explicit Picture(const std::vector<Eigen::Vector2d>& cells) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 2.0);
    const auto line = [](double d) { return std::exp(-0.5 * d * d / (1.4 * 1.4)); };
    for (int y = 0; y < kHeight_px; ++y)
      for (int x = 0; x < kWidth_px; ++x) {
        double value = 150.0;
        for (const Eigen::Vector2d& center : cells) {
          const double r = (Eigen::Vector2d(x, y) - center).norm();
          value -= 60.0 * line(r - kRadius_px) + 55.0 * line(r - kRadius_px + kZona_px);
          value -= 25.0 / (1.0 + std::exp(r - kRadius_px + kZona_px));
        }
        pixels_.push_back(static_cast<std::uint8_t>(std::lround(value + noise(random))));
      }
  }
  ImageView view() const { return test::view_of_bytes(pixels_, kWidth_px, kHeight_px, 0.7); }

 private:
  std::vector<std::uint8_t> pixels_;
};

// A scene without a cell whose needle ends at the first one.
SceneReading scene_of(const Eigen::Vector2d& direction) {
  SceneReading scene;
  SceneTool needle;
  needle.direction = direction.normalized();
  needle.tip = kFirst_px - kRadius_px * needle.direction;
  needle.half_width_px = 4.0;
  needle.tip_share = 0.8;
  scene.needles.push_back(needle);
  return scene;
}

std::vector<SceneCell> added(const Picture& picture, SceneReading scene) {
  GrayImage whole;
  load(picture.view(), whole);
  SceneReader reader;
  add_ring_behind(scene, whole, {}, {kFirst_px, kRadius_px, 1.0, 0.0}, FrameSampler(picture.view()), reader);
  return scene.cells;
}

TEST(RingChoice, ACellBehindTheOneThatANeedlePointsThroughIsAdded) {
  const std::vector<SceneCell> cells = added(Picture({kFirst_px, kSecond_px}), scene_of(kSecond_px - kFirst_px));
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_LT((cells[0].center - kSecond_px).norm(), 3.0);
  EXPECT_NEAR(cells[0].radius_px, kRadius_px, 0.25 * kRadius_px);
  EXPECT_GE(cells[0].share, 0.9);
}

TEST(RingChoice, NoneBesideTheNeedlesWay) {
  EXPECT_TRUE(added(Picture({kFirst_px, kSecond_px}), scene_of({0.0, 1.0})).empty());
}

TEST(RingChoice, NoneWhereThereIsNone) {
  EXPECT_TRUE(added(Picture({kFirst_px}), scene_of(kSecond_px - kFirst_px)).empty());
}

}  // namespace
}  // namespace pellucida
