#include "TestFiles.h"

namespace pellucida {
namespace {

using namespace test;

constexpr SourceOptions kPixelsAlone{.pixel_size_um = 0.825, .frame_rate_hz = {}};

TEST(Video, EachContainerGivesAllItsFrames) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> kinds[] = {
      {"a.avi", "MJPG"}, {"b.mkv", "MJPG"}, {"c.mp4", "mp4v"}, {"d.avi", "FFV1"}};
  for (const auto& [name, codec] : kinds) {
    write_video(folder / name, 24, 25.0, codec);
    const auto source = open_source(folder / name, kPixelsAlone);
    EXPECT_EQ(source->info().width_px, 64) << name;
    EXPECT_EQ(source->info().height_px, 48) << name;
    EXPECT_EQ(source->info().bit_depth, 8) << name;
    EXPECT_NEAR(source->info().frame_rate_hz, 25.0, 1e-6) << name;
    EXPECT_EQ(source->info().frame_rate_origin, "metadata") << name;
    const auto frames = all_frames(*source);
    ASSERT_EQ(frames.size(), 24U) << name;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_EQ(frames[i].frame_index, static_cast<long>(i)) << name;
      EXPECT_EQ(frames[i].gap_count, 0) << name;
      EXPECT_NEAR(frames[i].time_s, static_cast<double>(i) / 25.0, 1e-6) << name;
      EXPECT_LT(cv::norm(mat_of(frames[i]), picture(static_cast<int>(i % 8), 64, 48), cv::NORM_L1) / (64 * 48), 3.0)
          << name;
    }
    EXPECT_FALSE(source->next()) << name;
  }
}

TEST(Video, LosslessPixelsAreExact) {
  const TemporaryFolder folder;
  write_video(folder / "a.avi", 3, 25.0, "FFV1");
  const auto frames = all_frames(*open_source(folder / "a.avi", kPixelsAlone));
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_TRUE(same_pixels(mat_of(frames[2]), picture(2, 64, 48)));
}

TEST(Video, StartsAnew) {
  const TemporaryFolder folder;
  write_video(folder / "a.avi", 10, 25.0);
  const auto source = open_source(folder / "a.avi", kPixelsAlone);
  const auto first = all_frames(*source);
  ASSERT_TRUE(source->restart());
  const auto second = all_frames(*source);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].time_s, second[i].time_s);
    EXPECT_TRUE(same_pixels(mat_of(first[i]), mat_of(second[i])));
  }
}

TEST(Video, GivenRateStretchesTime) {
  const TemporaryFolder folder;
  write_video(folder / "a.avi", 10, 25.0);
  const auto source = open_source(folder / "a.avi", {.pixel_size_um = 1.0, .frame_rate_hz = 100.0});
  EXPECT_EQ(source->info().frame_rate_origin, "option");
  const auto frames = all_frames(*source);
  ASSERT_EQ(frames.size(), 10U);
  EXPECT_NEAR(frames[9].time_s, 0.09, 1e-6);
  EXPECT_EQ(frames[9].frame_index, 9);
}

// Twelve frames at 10 frames/s of which 3, 4 and 8 were never written: their stamps are missing.
TEST(Video, LostFramesAreCountedFromTheStamps) {
  const std::string file = PELLUCIDA_SOURCE_DIR "/tests/acquisition/data/three_frames_lost.mkv";
  const auto frames = all_frames(*open_source(file, kPixelsAlone));
  ASSERT_EQ(frames.size(), 9U);
  const long indices[] = {0, 1, 2, 5, 6, 7, 9, 10, 11};
  const long gaps[] = {0, 0, 0, 2, 0, 0, 1, 0, 0};
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(frames[i].frame_index, indices[i]);
    EXPECT_EQ(frames[i].gap_count, gaps[i]);
    EXPECT_NEAR(frames[i].time_s, static_cast<double>(indices[i]) / 10.0, 1e-6);
  }
}

TEST(Video, CutOffGivesItsFramesThenSaysWhere) {
  const TemporaryFolder folder;
  for (const char* name : {"a.avi", "b.mkv"}) {
    write_video(folder / name, 60, 30.0);
    cut(folder / name, 0.5);
    const auto source = open_source(folder / name, kPixelsAlone);
    long last = -1;
    expect_error(ExitCode::kInputUnreadable, "broken off after frame", [&] {
      while (const auto frame = source->next()) last = frame->frame_index;
    });
    EXPECT_GT(last, 15) << name;
    EXPECT_LT(last, 45) << name;
    // After the error, the source is at its end.
    EXPECT_FALSE(source->next()) << name;
    // The text names the frame and the count.
    source->restart();
    expect_error(ExitCode::kInputUnreadable,
                 "after frame " + std::to_string(last) + " (" + std::to_string(last + 1) + " frames were read, about " +
                     std::to_string(60 - last - 1) + " of 60 are missing)",
                 [&] { all_frames(*source); });
  }
}

TEST(Video, Mp4WithoutItsIndexSaysSo) {
  const TemporaryFolder folder;
  write_video(folder / "a.mp4", 30, 30.0, "mp4v");
  cut(folder / "a.mp4", 0.5);
  expect_error(ExitCode::kInputUnreadable, "a.mp4: cut off (an MP4 without its index",
               [&] { open_source(folder / "a.mp4", kPixelsAlone); });
}

}  // namespace
}  // namespace pellucida
