#include "SceneReading.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucida {
namespace {

// A map of background, 100 x 80, 3 px a map pixel.
class SceneReadingTest : public ::testing::Test {
 protected:
  static constexpr int kWidth = 100, kHeight = 80;
  static constexpr double kPitch_px = 3.0;

  SceneReadingTest() {
    for (auto& plane : map_.shares) plane.setZero(kHeight, kWidth);
    map_.tip.setZero(kHeight, kWidth);
    map_.pitch_px = kPitch_px;
  }

  template <class Inside>
  void fill(SceneClass which, const Inside& inside) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        if (inside(x, y)) map_.shares[static_cast<std::size_t>(which)](y, x) = 0.95F;
  }

  SceneReading read() const {
    return read_scene(map_, static_cast<int>(kWidth * kPitch_px), static_cast<int>(kHeight * kPitch_px));
  }

  SceneMap map_;
};

TEST_F(SceneReadingTest, AHolderPointsFromTheBorderToItsMouth) {
  fill(SceneClass::kHolder, [](int x, int y) { return x >= 70 && y >= 35 && y < 45; });
  const SceneReading reading = read();
  ASSERT_EQ(reading.holders.size(), 1U);
  const SceneTool& holder = reading.holders.front();
  EXPECT_NEAR(holder.direction.x(), -1.0, 0.01);
  EXPECT_NEAR(holder.half_width_px, 5.0 * kPitch_px, 0.1 * 5.0 * kPitch_px);
  EXPECT_FALSE(holder.is_short);
}

TEST(WorkedOn, ACellAtAHolderOrBeforeANeedleIsAndABystanderIsNot) {
  const Eigen::Vector2d held(150.0, 100.0), bystander(150.0, 230.0);
  constexpr double kRadius_px = 50.0;
  SceneTool holder, needle;
  holder.tip = {205.0, 100.0};
  holder.direction = {-1.0, 0.0};
  needle.tip = {60.0, 110.0};
  needle.direction = {1.0, 0.0};
  for (const SceneReading& seen : {SceneReading{{}, {}, {holder}}, SceneReading{{}, {needle}, {}}}) {
    EXPECT_TRUE(is_worked_on(seen, held, kRadius_px));
    EXPECT_FALSE(is_worked_on(seen, bystander, kRadius_px));
  }
  EXPECT_FALSE(is_worked_on({}, held, kRadius_px));
}

// From the left and the right, the left one narrower; with the mark of a needle's tip or without.
TEST_F(SceneReadingTest, OfTwoHoldersThatFaceEachOtherTheOneWithATipIsTheNeedle) {
  fill(SceneClass::kHolder,
       [](int x, int y) { return (x < 40 && y >= 37 && y < 43) || (x >= 65 && y >= 33 && y < 47); });
  SceneReading reading = read();
  EXPECT_EQ(reading.holders.size(), 2U);
  EXPECT_TRUE(reading.needles.empty());
  map_.tip(40, 39) = 0.7F;
  reading = read();
  ASSERT_EQ(reading.holders.size(), 1U);
  EXPECT_NEAR(reading.holders.front().direction.x(), -1.0, 0.01);
  ASSERT_EQ(reading.needles.size(), 1U);
  EXPECT_NEAR(reading.needles.front().direction.x(), 1.0, 0.01);
  // Where there is a needle, both are as they are.
  fill(SceneClass::kNeedle, [](int x, int y) { return y < 25 && x >= 50 && x < 54; });
  EXPECT_EQ(read().holders.size(), 2U);
}

// A long part of a holding pipette that looks like a needle, and a needle.
TEST_F(SceneReadingTest, ANeedleWithATipComesBeforeALongerOneWithout) {
  fill(SceneClass::kNeedle,
       [](int x, int y) { return (x < 50 && y >= 50 && y < 56) || (x >= 75 && y >= 20 && y < 24); });
  EXPECT_GT(read().needles.front().direction.x(), 0.9);
  map_.tip(21, 75) = 0.9F;
  const SceneReading reading = read();
  ASSERT_EQ(reading.needles.size(), 2U);
  EXPECT_LT(reading.needles.front().direction.x(), -0.9);
}

// Less of it in view than it is wide: its longest axis lies across it.
TEST_F(SceneReadingTest, AHolderOfWhichLittleIsInViewIsOne) {
  fill(SceneClass::kHolder, [](int x, int y) { return y < 14 && x >= 40 && x < 58; });
  const SceneReading reading = read();
  ASSERT_EQ(reading.holders.size(), 1U);
  EXPECT_TRUE(reading.holders.front().is_short);
  EXPECT_GT(reading.holders.front().direction.y(), 0.94);
}

// However much wider than long.
TEST_F(SceneReadingTest, AHolderMuchWiderThanLongComesInFromTheBorder) {
  fill(SceneClass::kHolder, [](int x, int y) { return y < 16 && x >= 30 && x < 66; });
  const SceneReading reading = read();
  ASSERT_EQ(reading.holders.size(), 1U);
  const SceneTool& holder = reading.holders.front();
  EXPECT_TRUE(holder.is_short);
  EXPECT_GT(holder.direction.y(), 0.94);
  EXPECT_NEAR(holder.half_width_px, 18.0 * kPitch_px, 0.1 * 18.0 * kPitch_px);
}

// The direction of its end, not of the whole arc.
TEST_F(SceneReadingTest, ABentHolderPointsAsItsEndDoes) {
  // A quarter of a circle about the corner (99, 79), in from the right border, with its mouth pointing down.
  fill(SceneClass::kHolder, [](int x, int y) {
    const double radius = std::hypot(x - 99.0, y - 79.0);
    return radius > 52.0 && radius < 64.0 && y < 70;
  });
  const SceneReading reading = read();
  ASSERT_EQ(reading.holders.size(), 1U);
  const SceneTool& holder = reading.holders.front();
  EXPECT_TRUE(holder.is_short);
  EXPECT_GT(holder.direction.y(), std::cos(25.0 * M_PI / 180.0)) << holder.direction.transpose();
  EXPECT_NEAR(holder.half_width_px, 6.0 * kPitch_px, 0.25 * 6.0 * kPitch_px);
}

// Its rest is not seen as one, and the border is nearer to its mouth than to its other end.
TEST_F(SceneReadingTest, APartOfAHolderAmidTheImageEndsAtTheCellItHolds) {
  const auto part = [](int x, int y) { return x >= 40 && x < 60 && y >= 35 && y < 43; };
  fill(SceneClass::kHolder, part);
  ASSERT_EQ(read().holders.size(), 1U);
  EXPECT_NEAR(read().holders.front().direction.x(), 1.0, 0.01);
  fill(SceneClass::kInside, [&](int x, int y) { return std::hypot(x - 26.0, y - 39.0) < 14.0 && !part(x, y); });
  ASSERT_EQ(read().holders.size(), 1U);
  EXPECT_NEAR(read().holders.front().direction.x(), -1.0, 0.01);
}

// Nor is a short, broad area of the needle's class a needle.
TEST_F(SceneReadingTest, ANeedleIsSlender) {
  fill(SceneClass::kNeedle, [](int x, int y) { return y < 14 && x >= 40 && x < 58; });
  EXPECT_TRUE(read().needles.empty());
}

}  // namespace
}  // namespace pellucida
