#include "CommandedMotion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucida {
namespace {

const Eigen::Vector2d kDirection(0.8, 0.6);
constexpr double kSigma_px = 0.5;

// A needle that goes `way_px` along its direction per frame, sent by a manipulator that calls this `command_px`.
class Needle {
 public:
  explicit Needle(const Eigen::Vector2d& command_px) : command_px_(command_px) {
    motion_.learn(tip(), kDirection, kSigma_px, true);
  }
  Eigen::Vector2d tip(double ahead_px = 0.0) const { return (place_px_ + ahead_px) * kDirection; }
  // One frame, seen.
  void go(double way_px) {
    begin(way_px);
    motion_.learn(tip(wobble_px_), kDirection, kSigma_px, false);
  }
  void begin(double way_px) {
    place_px_ += way_px;
    wobble_px_ = -wobble_px_;
    motion_.begin(Eigen::Vector2d(way_px * command_px_));
  }
  CommandedMotion& motion() { return motion_; }

 private:
  Eigen::Vector2d command_px_;
  double place_px_ = 100.0, wobble_px_ = 0.2;
  CommandedMotion motion_;
};

TEST(CommandedMotion, IsBelievedOnceTheTipGoesWhereItIsSent) {
  Needle needle(kDirection);
  needle.go(2.0);
  EXPECT_FALSE(needle.motion().due(needle.tip()));
  for (int k = 0; k < 10; ++k) needle.go(2.0);
  needle.begin(2.0);
  const auto due = needle.motion().due(needle.tip());
  ASSERT_TRUE(due);
  EXPECT_NEAR(due->ahead_px, 0.0, 0.5);
  EXPECT_LT(due->sigma_px, 0.8);
}

TEST(CommandedMotion, LearnsScaleAndAxes) {
  // Twice the way, mirrored, and turned by 70 degrees.
  Needle needle(0.5 * Eigen::Vector2d(0.3, -0.95));
  for (int k = 0; k < 12; ++k) needle.go(3.0);
  needle.begin(3.0);
  const auto due = needle.motion().due(needle.tip());
  ASSERT_TRUE(due);
  EXPECT_NEAR(due->ahead_px, 0.0, 0.6);
}

TEST(CommandedMotion, ATipThatStaysIsNotTheNeedlesThatIsSent) {
  CommandedMotion motion;
  motion.learn({50.0, 50.0}, kDirection, kSigma_px, true);
  for (int k = 0; k < 30; ++k) {
    motion.begin(Eigen::Vector2d(3.0 * kDirection));
    motion.learn({50.0 + 0.2 * std::cos(k), 50.0}, kDirection, kSigma_px, false);
    EXPECT_FALSE(motion.due({50.0, 50.0}));
    EXPECT_FALSE(motion.contradicts({40.0, 42.5}, kSigma_px));
  }
}

TEST(CommandedMotion, ATipThatSpringsBackUncommandedIsMisread) {
  Needle needle(kDirection);
  for (int k = 0; k < 12; ++k) needle.go(2.0);
  for (int k = 0; k < 10; ++k) {
    needle.begin(2.0);
    EXPECT_TRUE(needle.motion().contradicts(needle.tip(-8.0 - 2.0 * k), kSigma_px)) << k;
    needle.motion().misread();
  }
  // For so long it isn't.
  needle.begin(2.0);
  EXPECT_FALSE(needle.motion().contradicts(needle.tip(-30.0), kSigma_px));
  needle.motion().learn(needle.tip(-30.0), kDirection, kSigma_px, false);
  for (int k = 0; k < 4; ++k) {
    needle.begin(2.0);
    EXPECT_FALSE(needle.motion().contradicts(needle.tip(-30.0), kSigma_px));
    needle.motion().learn(needle.tip(-30.0), kDirection, kSigma_px, false);
  }
}

TEST(CommandedMotion, ATipThatLagsOrIsDrawnBackIsBelieved) {
  Needle needle(kDirection);
  for (int k = 0; k < 12; ++k) needle.go(2.0);
  // Steps are missed: it stands still.
  const Eigen::Vector2d halted = needle.tip();
  for (int k = 0; k < 4; ++k) {
    needle.begin(2.0);
    EXPECT_FALSE(needle.motion().contradicts(halted, kSigma_px)) << k;
    needle.motion().learn(halted, kDirection, kSigma_px, false);
  }
  Needle drawn(kDirection);
  for (int k = 0; k < 12; ++k) drawn.go(4.0);
  // The film shows the turn a frame late, and its end.
  const Eigen::Vector2d turn = drawn.tip();
  drawn.begin(-4.0);
  EXPECT_FALSE(drawn.motion().contradicts(turn, kSigma_px));
  drawn.motion().learn(turn, kDirection, kSigma_px, false);
  drawn.begin(0.0);
  EXPECT_FALSE(drawn.motion().contradicts(drawn.tip(), kSigma_px));
}

TEST(CommandedMotion, AJumpOfThePictureIsNone) {
  Needle needle(kDirection);
  for (int k = 0; k < 12; ++k) needle.go(2.0);
  const Eigen::Vector2d jump_px = -20.0 * kDirection;
  needle.begin(2.0);
  needle.motion().move_scene(jump_px);
  EXPECT_FALSE(needle.motion().contradicts(needle.tip() + jump_px, kSigma_px));
  EXPECT_TRUE(needle.motion().contradicts(needle.tip(-10.0) + jump_px, kSigma_px));
}

}  // namespace
}  // namespace pellucida
