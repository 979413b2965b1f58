#include "FrameStretch.h"

#include <gtest/gtest.h>

#include <vector>

namespace pellucida {
namespace {

// 30 frames a second; what it gives for the frames that `happened` says.
template <class Happened>
std::vector<FrameStretch> stretches(long frame_count, Happened happened) {
  FrameStretchFinder finder;
  std::vector<FrameStretch> found;
  for (long frame = 0; frame < frame_count; ++frame) {
    if (const auto ended = finder.add(frame, static_cast<double>(frame) / 30.0, happened(frame) ? 1 : 0)) {
      found.push_back(*ended);
    }
  }
  if (const auto rest = finder.finish()) found.push_back(*rest);
  EXPECT_FALSE(finder.finish());
  return found;
}

TEST(FrameStretch, NothingHappenedNothingFound) {
  EXPECT_TRUE(stretches(100, [](long) { return false; }).empty());
}

TEST(FrameStretch, EveryOtherFrameIsOneStretch) {
  const auto found = stretches(300, [](long frame) { return frame >= 30 && frame < 90 && frame % 2 == 0; });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].first_frame, 30);
  EXPECT_EQ(found[0].last_frame, 88);
  EXPECT_EQ(found[0].frame_count, 30);
  EXPECT_DOUBLE_EQ(found[0].begin_s, 1.0);
}

TEST(FrameStretch, QuietTimesPartThem) {
  const auto found = stretches(600, [](long frame) { return frame < 10 || (frame >= 300 && frame < 305); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].frame_count, 10);
  EXPECT_EQ(found[1].first_frame, 300);
  EXPECT_EQ(found[1].frame_count, 5);
}

TEST(FrameStretch, FramesLostBeforeAFrameCountEach) {
  FrameStretchFinder finder;
  finder.add(10, 1.0, 3);
  finder.add(14, 1.2, 2);
  const auto stretch = finder.finish();
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->frame_count, 5);
  EXPECT_EQ(stretch->last_frame, 14);
}

// A crash costs at most what the newest stretch would have said; an hour is no single row.
TEST(FrameStretch, NoneIsLongerThanTheLongest) {
  const auto found = stretches(30 * 600, [](long) { return true; });
  EXPECT_GE(found.size(), 10U);
  EXPECT_LE(found.size(), 11U);
  long count = 0;
  for (const FrameStretch& stretch : found) {
    EXPECT_LE(stretch.end_s - stretch.begin_s, FrameStretchFinder::kLongest_s);
    count += stretch.frame_count;
  }
  EXPECT_EQ(count, 30 * 600);
}

}  // namespace
}  // namespace pellucida
