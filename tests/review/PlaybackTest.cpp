// The position in a recorded session while it is played.
#include "presenters/Playback.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(Playback, FollowsTheTimesOfTheSessionAndSkipsWhatIsOver) {
  Playback playback({0.0, 0.1, 0.2, 1.0, 1.1, 2.0});
  playback.play(true, 100.0);
  EXPECT_FALSE(playback.tick(100.05));
  EXPECT_TRUE(playback.tick(100.15));
  EXPECT_EQ(playback.step(), 1U);
  // Late by most of a second: the frames between are left out.
  EXPECT_TRUE(playback.tick(101.05));
  EXPECT_EQ(playback.step(), 3U);
  EXPECT_NEAR(playback.position_s(), 1.05, 1e-9);
}

TEST(Playback, EndsAtTheEndAndBeginsAgainFromThere) {
  Playback playback({0.0, 1.0, 2.0});
  playback.play(true, 0.0);
  EXPECT_TRUE(playback.tick(5.0));
  EXPECT_EQ(playback.step(), 2U);
  EXPECT_FALSE(playback.playing());
  playback.play(true, 6.0);
  EXPECT_EQ(playback.step(), 0U);
  EXPECT_TRUE(playback.playing());
}

TEST(Playback, LoopsAndKeepsThePaceOverTheEnd) {
  Playback playback({0.0, 1.0, 2.0});
  playback.set_loop(true);
  playback.play(true, 0.0);
  playback.tick(3.25);
  EXPECT_TRUE(playback.playing());
  EXPECT_DOUBLE_EQ(playback.position_s(), 1.25);
  EXPECT_EQ(playback.step(), 1U);
}

TEST(Playback, BackwardsAtAnySpeed) {
  Playback playback({0.0, 1.0, 2.0});
  playback.set_backwards(true, 0.0);
  playback.set_speed_ratio(0.5, 0.0);
  playback.play(true, 0.0);
  EXPECT_EQ(playback.step(), 2U);
  playback.tick(2.0);
  EXPECT_DOUBLE_EQ(playback.position_s(), 1.0);
  EXPECT_EQ(playback.step(), 1U);
  // A change of speed doesn't move the position.
  playback.set_speed_ratio(10.0, 2.0);
  EXPECT_DOUBLE_EQ(playback.position_s(), 1.0);
  playback.tick(2.05);
  EXPECT_NEAR(playback.position_s(), 0.5, 1e-9);
  playback.set_speed_ratio(1000.0, 2.05);
  EXPECT_EQ(playback.speed_ratio(), Playback::kMostSpeed_ratio);
}

TEST(Playback, StepsStayWithinTheSessionAndEndPlaying) {
  Playback playback({0.0, 0.0, 2.0});
  playback.play(true, 0.0);
  playback.step_by(1);
  EXPECT_FALSE(playback.playing());
  // Two steps share a time: each can be reached.
  EXPECT_EQ(playback.step(), 2U);
  playback.step_by(-1);
  EXPECT_EQ(playback.step(), 1U);
  playback.step_by(-10);
  EXPECT_EQ(playback.step(), 0U);
  playback.step_by(99);
  EXPECT_EQ(playback.step(), 2U);
  playback.go_to_time(-5.0, 0.0);
  EXPECT_EQ(playback.position_s(), 0.0);
  Playback nothing;
  nothing.step_by(1);
  nothing.play(true, 0.0);
  EXPECT_FALSE(nothing.tick(1.0));
}

}  // namespace
}  // namespace pellucida
