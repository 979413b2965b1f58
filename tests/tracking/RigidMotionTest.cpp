// The holder's rigid motion and the picture's jumps, on pictures drawn here: two walls of glass that end in round rims.
#include "RigidMotion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "GlobalShiftEstimator.h"

namespace pellucida {
namespace {

constexpr int kSceneWidth = 320, kSceneHeight = 240;
const Eigen::Vector2d kPivot(150.0, 120.0);

// A dark line along a wall, ending in a rim at x = 90: brightness at a place of the undisturbed scene.
double scene(const Eigen::Vector2d& p) {
  double value = 0.6;
  for (const double wall : {95.0, 145.0}) {
    const Eigen::Vector2d nearest(std::min(p.x(), 90.0), wall);
    const double distance = std::abs((p - nearest).norm() - 5.0);
    value -= 0.25 * std::exp(-0.5 * distance * distance / 2.25);
  }
  return value;
}

struct ScenePicture {
  std::vector<std::uint8_t> pixels;
  ImageView view() const { return {pixels.data(), PixelFormat::kGray8, kSceneWidth, kSceneHeight, kSceneWidth, 1.0}; }
};

ScenePicture draw_scene(const RigidMove& move, double light = 1.0, double noise = 0.0, unsigned seed = 1) {
  ScenePicture picture;
  std::mt19937 random(seed);
  std::normal_distribution<double> error(0.0, 1.0);
  for (int y = 0; y < kSceneHeight; ++y) {
    for (int x = 0; x < kSceneWidth; ++x) {
      const double value = light * scene(move.undo({x, y})) + noise * error(random);
      picture.pixels.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(255.0 * value), 0L, 255L)));
    }
  }
  return picture;
}

std::vector<Eigen::Vector2d> around_the_rims() {
  std::vector<Eigen::Vector2d> points;
  for (int y = 80; y < 160; ++y)
    for (int x = 30; x < 105; ++x) points.emplace_back(x, y);
  return points;
}

RigidMove moved(double x, double y, double angle_deg) {
  return {{x, y}, angle_deg * M_PI / 180.0, kPivot};
}

class RigidMotionTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(motion_.learn(FrameSampler(still_.view()), around_the_rims(), kPivot, 0.003)); }
  ScenePicture still_ = draw_scene(moved(0, 0, 0));
  RigidMotion motion_;
};

TEST_F(RigidMotionTest, ShiftsAndTurnsToAFewHundredthsOfAPixel) {
  for (int k = 1; k <= 20; ++k) {
    const RigidMove truth = moved(0.31 * k, -0.17 * k, 0.4 * k);
    const ScenePicture now = draw_scene(truth);
    ASSERT_TRUE(motion_.track(FrameSampler(now.view()), 20.0, Eigen::Vector2d::Zero())) << "frame " << k;
    EXPECT_LT((motion_.motion().shift - truth.shift).norm(), 0.05) << "frame " << k;
    EXPECT_NEAR(motion_.motion().angle_rad, truth.angle_rad, 5e-4) << "frame " << k;
  }
}

TEST_F(RigidMotionTest, ALampTurnedDownMovesNothing) {
  const ScenePicture now = draw_scene(moved(0.6, 0.4, 0.0), 0.5);
  ASSERT_TRUE(motion_.track(FrameSampler(now.view()), 20.0, Eigen::Vector2d::Zero()));
  EXPECT_LT((motion_.motion().shift - Eigen::Vector2d(0.6, 0.4)).norm(), 0.05);
}

TEST_F(RigidMotionTest, ItsSigmaHoldsInNoise) {
  RigidMotion noisy;
  constexpr double kNoise = 0.03;
  ASSERT_TRUE(noisy.learn(FrameSampler(still_.view()), around_the_rims(), kPivot, kNoise));
  double squares = 0.0;
  for (unsigned k = 0; k < 60; ++k) {
    const ScenePicture now = draw_scene(moved(0.2, 0.1, 0.0), 1.0, kNoise, k);
    ASSERT_TRUE(noisy.track(FrameSampler(now.view()), 20.0, Eigen::Vector2d::Zero()));
    squares += std::pow((noisy.motion().shift.x() - 0.2) / noisy.sigma_px(Eigen::Vector2d::UnitX()), 2);
  }
  EXPECT_LT(std::sqrt(squares / 60.0), 1.5);
}

TEST_F(RigidMotionTest, AJumpAlongTheWallsIsFoundAtTheRims) {
  const RigidMove truth = moved(26.0, 0.0, 0.0);
  const ScenePicture now = draw_scene(truth);
  ASSERT_TRUE(motion_.track(FrameSampler(now.view()), 40.0, {23.0, 2.0}));
  EXPECT_LT((motion_.motion().shift - truth.shift).norm(), 1e-6);
}

TEST_F(RigidMotionTest, APlaceWhereThePixelsFitWorseIsNotTaken) {
  const RigidMove truth = moved(1.0, 0.5, 0.0);
  const ScenePicture now = draw_scene(truth);
  const FrameSampler image(now.view());
  ASSERT_TRUE(motion_.track(image, 20.0, Eigen::Vector2d::Zero()));
  EXPECT_FALSE(motion_.correct(image, {-14.0, 0.5}));
  EXPECT_LT((motion_.motion().shift - truth.shift).norm(), 0.1);
}

TEST_F(RigidMotionTest, ThePlaceWhereThePixelsFitIsTaken) {
  const RigidMove truth = moved(14.0, 0.0, 0.0);
  const ScenePicture now = draw_scene(truth);
  EXPECT_TRUE(motion_.correct(FrameSampler(now.view()), {13.0, 0.0}));
  EXPECT_LT((motion_.motion().shift - truth.shift).norm(), 1e-3);
}

TEST_F(RigidMotionTest, WallsThatFitFarWorseThanUsualAreNotFound) {
  for (int frame = 0; frame < 8; ++frame) {
    const ScenePicture now = draw_scene(moved(0.1 * frame, 0.0, 0.0), 1.0, 0.003, 20 + frame);
    ASSERT_TRUE(motion_.track(FrameSampler(now.view()), 20.0, Eigen::Vector2d::Zero()));
  }
  const Eigen::Vector2d last = motion_.motion().shift;
  // The rims are gone, and with them what tells a motion along the walls.
  const ScenePicture away = draw_scene(moved(60.0, 0.0, 0.0), 1.0, 0.003, 40);
  EXPECT_FALSE(motion_.track(FrameSampler(away.view()), 20.0, Eigen::Vector2d::Zero()));
  EXPECT_EQ(motion_.motion().shift, last);
}

TEST_F(RigidMotionTest, AnEmptyPictureIsNotFollowed) {
  const std::vector<std::uint8_t> gray(kSceneWidth * kSceneHeight, 150);
  const ImageView view{gray.data(), PixelFormat::kGray8, kSceneWidth, kSceneHeight, kSceneWidth, 1.0};
  EXPECT_FALSE(motion_.track(FrameSampler(view), 20.0, Eigen::Vector2d::Zero()));
}

TEST(RigidMotion, OneStraightWallCannotTellAMotionAlongIt) {
  ScenePicture picture;
  for (int y = 0; y < kSceneHeight; ++y)
    for (int x = 0; x < kSceneWidth; ++x) picture.pixels.push_back(std::abs(y - 120) < 3 ? 60 : 150);
  RigidMotion motion;
  EXPECT_FALSE(motion.learn(FrameSampler(picture.view()), around_the_rims(), kPivot, 0.003));
  EXPECT_FALSE(motion.valid());
}

TEST(RigidMove, UndoIsTheInverse) {
  const RigidMove move = moved(3.0, -7.0, 33.0);
  const Eigen::Vector2d p(12.0, 45.0);
  EXPECT_LT((move.undo(move.apply(p)) - p).norm(), 1e-12);
}

TEST(GlobalShiftEstimator, NoticesAKnockAndNothingElse) {
  GlobalShiftEstimator scene;
  for (unsigned k = 0; k < 10; ++k) {
    const ScenePicture now = draw_scene(moved(0.1 * k, 0.0, 0.0), k < 5 ? 1.0 : 0.7, 0.01, k);
    EXPECT_FALSE(scene.update(FrameSampler(now.view()))) << "frame " << k;
  }
  const ScenePicture knocked = draw_scene(moved(25.0, -14.0, 0.0), 0.7, 0.01, 99);
  const auto jump = scene.update(FrameSampler(knocked.view()));
  ASSERT_TRUE(jump);
  EXPECT_LT((*jump - Eigen::Vector2d(24.1, -14.0)).norm(), 2.2);
}

}  // namespace
}  // namespace pellucida
