#include "pellucida/session/SessionSource.h"

#include <gtest/gtest.h>

#include <fstream>

#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/Sha256.h"

namespace pellucida {
namespace {

using namespace test;

fs::path image_of(const fs::path& session, const std::string& digits) {
  return session / "frames" / ("frame_" + digits + ".vti");
}

std::vector<Frame> all_frames_of(SessionSource& source) {
  std::vector<Frame> frames;
  while (auto frame = source.next()) frames.push_back(std::move(*frame));
  return frames;
}

std::vector<long> numbers_of(const std::vector<Frame>& frames) {
  std::vector<long> numbers;
  for (const Frame& frame : frames) numbers.push_back(frame.frame_index);
  return numbers;
}

int first_pixel(const Frame& frame) {
  return static_cast<const std::uint8_t*>(view_of(frame.image.get()).data)[0];
}

TEST(SessionSource, DeliversTheFramesAsTheyWereRecorded) {
  const TemporaryFolder folder;
  write_session(folder / "s", 4);
  SessionSource source(folder / "s");
  EXPECT_EQ(source.info().frame_count, 4);
  EXPECT_EQ(source.info().width_px, 6);
  EXPECT_EQ(source.info().pixel_size_um, 0.825);
  EXPECT_EQ(source.info().pixel_size_origin, "session");
  EXPECT_EQ(source.info().frame_rate_hz, 30.0);
  EXPECT_FALSE(source.info().live);
  const auto frames = all_frames_of(source);
  ASSERT_EQ(frames.size(), 4U);
  for (long i = 0; i < 4; ++i) {
    const Frame& frame = frames[static_cast<std::size_t>(i)];
    EXPECT_EQ(frame.frame_index, i);
    EXPECT_EQ(frame.time_s, time_of(i));  // all digits, not the nine of the table
    EXPECT_EQ(stamped_time_s(frame.image.get()), time_of(i));
    EXPECT_EQ(frame.gap_count, 0);
    EXPECT_EQ(frame.run_index, 0);
    EXPECT_EQ(first_pixel(frame), i);
    EXPECT_EQ(view_of(frame.image.get()).pixel_size_um, 0.825);
  }
  EXPECT_TRUE(source.restart());
  EXPECT_EQ(numbers_of(all_frames_of(source)), (std::vector<long>{0, 1, 2, 3}));
}

TEST(SessionSource, AManipulatorsPlaceComesBackToTheBit) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    Scene scene = make_scene(0);
    scene.measurement.manipulator_x_um = -12.345;
    scene.measurement.manipulator_y_um = 1987.654;
    writer.write(scene);
    writer.write(make_scene(1));
    writer.close();
  }
  SessionSource source(folder / "s");
  const auto frames = all_frames_of(source);
  ASSERT_EQ(frames.size(), 2U);
  ASSERT_TRUE(frames[0].manipulator_um);
  EXPECT_EQ(*frames[0].manipulator_um, Eigen::Vector2d(-12.345, 1987.654));
  EXPECT_FALSE(frames[1].manipulator_um);
}

TEST(SessionSource, AnImageThatIsNotThereIsCountedAndShiftsNoTime) {
  const TemporaryFolder folder;
  write_session(folder / "s", 6);
  fs::remove(image_of(folder / "s", "00000002"));
  std::ofstream(image_of(folder / "s", "00000004")) << "no image";
  SessionSource source(folder / "s");
  const auto frames = all_frames_of(source);
  EXPECT_EQ(numbers_of(frames), (std::vector<long>{0, 1, 3, 5}));
  EXPECT_EQ(frames[2].time_s, time_of(3));
  EXPECT_EQ(frames[2].gap_count, 1);
  EXPECT_EQ(frames[3].time_s, time_of(5));
  EXPECT_EQ(source.absent_count(), 1);
  EXPECT_EQ(source.damaged_count(), 1);
  EXPECT_NE(source.first_damage().find("frame_00000004.vti"), std::string::npos) << source.first_damage();
}

TEST(SessionSource, AnImageUnderAnotherFramesNameIsNotTaken) {
  const TemporaryFolder folder;
  write_session(folder / "s", 3);
  fs::copy_file(image_of(folder / "s", "00000000"), image_of(folder / "s", "00000001"),
                fs::copy_options::overwrite_existing);
  SessionSource source(folder / "s");
  EXPECT_EQ(numbers_of(all_frames_of(source)), (std::vector<long>{0, 2}));
  EXPECT_EQ(source.damaged_count(), 1);
}

TEST(SessionSource, PlaysAPartOfIt) {
  const TemporaryFolder folder;
  write_session(folder / "s", 10);
  SessionSource source(folder / "s", {.from_s = time_of(2) - 0.01, .to_s = time_of(8) + 0.01, .every = 3});
  const auto frames = all_frames_of(source);
  EXPECT_EQ(numbers_of(frames), (std::vector<long>{2, 5, 8}));
  EXPECT_EQ(frames[1].time_s, time_of(5));
  for (const Frame& frame : frames) EXPECT_EQ(frame.gap_count, 0);  // left out on purpose
  EXPECT_EQ(source.info().frame_count, 3);
}

TEST(SessionSource, BackwardsTheTimeStillRises) {
  const TemporaryFolder folder;
  write_session(folder / "s", 4);
  SessionSource source(folder / "s", {.backwards = true});
  const auto frames = all_frames_of(source);
  ASSERT_EQ(frames.size(), 4U);
  for (long i = 0; i < 4; ++i) {
    const Frame& frame = frames[static_cast<std::size_t>(i)];
    EXPECT_EQ(first_pixel(frame), 3 - i);
    EXPECT_EQ(frame.frame_index, i);
    EXPECT_NEAR(frame.time_s, time_of(i), 1e-8);  // the table has nine digits
    EXPECT_EQ(stamped_time_s(frame.image.get()), frame.time_s);
    EXPECT_EQ(frame.gap_count, 0);
  }
}

TEST(SessionSource, EachPassOfALoopBeginsAnewLaterInTime) {
  const TemporaryFolder folder;
  write_session(folder / "s", 3);
  SessionSource source(folder / "s", {.loop_count = 3});
  const auto frames = all_frames_of(source);
  EXPECT_EQ(numbers_of(frames), (std::vector<long>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_NEAR(frames[i].time_s, time_of(static_cast<long>(i)), 1e-8);
    EXPECT_EQ(frames[i].run_index, static_cast<long>(i / 3));
    EXPECT_EQ(first_pixel(frames[i]), static_cast<int>(i % 3));
  }
  SessionSource endless(folder / "s", {.loop_count = 0});
  EXPECT_FALSE(endless.info().frame_count);
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(endless.next());
}

TEST(SessionSource, ALoopOverDamageEnds) {
  const TemporaryFolder folder;
  write_session(folder / "s", 2);
  for (const char* digits : {"00000000", "00000001"}) std::ofstream(image_of(folder / "s", digits)) << "no image";
  SessionSource source(folder / "s", {.loop_count = 0});
  EXPECT_FALSE(source.next());
  EXPECT_EQ(source.damaged_count(), 2);
}

TEST(SessionSource, SaysHowFarTheRecordedRunTookEachFrame) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    Scene measured = make_scene(0);
    measured.contact.frame_index = 0;
    writer.write(measured);
    writer.write(make_empty_scene(1));  // no time for it
    writer.write(make_scene(2));        // overtaken before the mechanics
    Scene tracked = make_scene(3);
    tracked.surface = {};
    writer.write(tracked);
    Scene anew = make_scene(4);
    anew.contact.frame_index = 4;
    anew.run_index = 1;
    writer.write(anew);
    writer.close();
  }
  SessionSource source(folder / "s");
  const auto frames = all_frames_of(source);
  ASSERT_EQ(frames.size(), 5U);
  EXPECT_EQ(frames[0].use, FrameUse::kMeasure);
  EXPECT_EQ(frames[1].use, FrameUse::kKeep);
  EXPECT_EQ(frames[2].use, FrameUse::kRevolve);
  EXPECT_EQ(frames[3].use, FrameUse::kTrack);
  EXPECT_EQ(frames[4].use, FrameUse::kMeasure);
  EXPECT_EQ(frames[3].run_index, 0);
  EXPECT_EQ(frames[4].run_index, 1);
  SessionSource all(folder / "s", {.all_frames = true});
  for (const Frame& frame : all_frames_of(all)) EXPECT_EQ(frame.use, FrameUse::kMeasure);
}

TEST(SessionSource, RefusesWhatCannotBePlayed) {
  const TemporaryFolder folder;
  EXPECT_THROW(SessionSource(folder / "nothing"), InputError);
  write_session(folder / "s", 2);
  EXPECT_THROW(SessionSource(folder / "s", {.from_s = 9.0}), UsageError);
  EXPECT_THROW(SessionSource(folder / "s", {.every = 0}), UsageError);
  EXPECT_THROW(SessionSource(folder / "s", {.pixel_size_um = 0.0}), UsageError);
  {
    SessionWriter writer(folder / "without", make_info(), {.frames = false});
    writer.write(make_scene(0));
    writer.close();
  }
  try {
    SessionSource source(folder / "without");
    FAIL() << "a session without images was opened";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("recorded without images"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(is_session(folder / "s"));
  EXPECT_FALSE(is_session(folder.path()));
}

TEST(SessionSource, AnotherPixelSizeIsTheImagesToo) {
  const TemporaryFolder folder;
  write_session(folder / "s", 1);
  SessionSource source(folder / "s", {.pixel_size_um = 0.5});
  EXPECT_EQ(source.info().pixel_size_origin, "option");
  const auto frame = source.next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(view_of(frame->image.get()).pixel_size_um, 0.5);
}

TEST(FrameStretches, HoldExactlyWhatWasAdded) {
  FrameStretches set;
  // Frames 0, 1, 2, 5, 6 and 9 were recorded; 3, 4, 7 and 8 were lost by the source.
  for (const auto& [frame, in_set] : {std::pair{0L, true}, {1L, true}, {2L, false}, {5L, true}, {6L, true}, {9L, true}})
    set.add(frame, in_set);
  EXPECT_EQ(set.stretches(), (std::vector<std::pair<long, long>>{{0, 1}, {5, 9}}));
  for (const long frame : {0L, 1L, 5L, 6L, 9L}) EXPECT_TRUE(set.holds(frame)) << frame;
  for (const long frame : {-1L, 2L, 3L, 4L, 10L}) EXPECT_FALSE(set.holds(frame)) << frame;
}

TEST(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  const TemporaryFolder folder;
  put(folder / "file", "abc");
  EXPECT_EQ(sha256_of_file(folder / "file"), sha256_of("abc"));
  EXPECT_THROW(sha256_of_file(folder / "none"), InputError);
}

}  // namespace
}  // namespace pellucida
