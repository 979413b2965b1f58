#include "pellucida/session/SessionReader.h"

#include <vtkCellData.h>

#include <stdexcept>

#include "SameData.h"
#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/vtk_files/SurfacePrecision.h"

namespace pellucida {
namespace {

using namespace test;

TEST(SessionReader, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  write_session(folder / "s", 4);
  const SessionReader session(folder / "s");
  EXPECT_TRUE(session.complete());
  EXPECT_EQ(session.hand_block_count(), 0U);
  ASSERT_EQ(session.steps().size(), 4U);
  for (long frame = 0; frame < 4; ++frame) {
    const Scene written = make_scene(frame);
    const Scene read = session.load(static_cast<std::size_t>(frame));
    expect_same(narrowed_surface(written.surface.shallow_copy()), read.surface.shallow_copy());
    expect_same(written.membranes.shallow_copy(), read.membranes.shallow_copy());
    expect_same(written.tools.shallow_copy(), read.tools.shallow_copy());
    const auto image = read.frame.shallow_copy();
    ASSERT_TRUE(image);
    EXPECT_EQ(image->GetDimensions()[0], 6);
    EXPECT_EQ(image->GetSpacing()[1], 0.825);
    expect_same_arrays(written.frame.shallow_copy()->GetPointData(), image->GetPointData());
    EXPECT_EQ(to_csv(read.measurement), to_csv(written.measurement));
  }
}

TEST(SessionReader, GivesBackA16BitImage) {
  const TemporaryFolder folder;
  std::vector<std::uint16_t> pixels{1, 300, 65535, 40000};
  Scene scene;
  scene.frame = Frozen(make_frame({pixels.data(), PixelFormat::kGray16, 2, 2, 4, 0.5}, 0.0, 0));
  {
    SessionInfo info = make_info();
    info.source.width_px = info.source.height_px = 2;
    info.source.pixel_size_um = 0.5;
    SessionWriter writer(folder / "s", info);
    writer.write(scene);
  }
  const Scene read = SessionReader(folder / "s").load(0);
  const ImageView view = view_of(read.frame.get());
  ASSERT_EQ(view.format, PixelFormat::kGray16);
  EXPECT_TRUE(std::equal(pixels.begin(), pixels.end(), static_cast<const std::uint16_t*>(view.data)));
}

TEST(SessionReader, GivesBackTheHead) {
  const TemporaryFolder folder;
  write_session(folder / "s", 1);
  const SessionReader session(folder / "s");
  const SessionInfo expected = make_info();
  EXPECT_EQ(session.info().source.name, expected.source.name);
  EXPECT_EQ(session.info().source.pixel_size_um, expected.source.pixel_size_um);
  EXPECT_EQ(session.info().source.frame_count, expected.source.frame_count);
  EXPECT_EQ(session.info().profile_json, expected.profile_json);
  EXPECT_EQ(session.info().seeds, expected.seeds);
  EXPECT_EQ(session.info().clock_offsets_s, expected.clock_offsets_s);
  EXPECT_EQ(session.info().command_line, expected.command_line);
  EXPECT_EQ(session.stated_counts().step_count, 1U);
}

TEST(SessionReader, KnowsWhichPartsAStepHas) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    writer.write(make_empty_scene(0));
    writer.write(make_scene(5));
  }
  const SessionReader session(folder / "s");
  EXPECT_FALSE(session.complete());
  ASSERT_EQ(session.steps().size(), 2U);
  EXPECT_TRUE(session.steps()[0].has(SessionPart::kFrame));
  EXPECT_FALSE(session.steps()[0].has(SessionPart::kSurface));
  EXPECT_EQ(session.steps()[1].frame_index, 5);
  EXPECT_TRUE(session.steps()[1].has(SessionPart::kTools));
  const Scene scene = session.load(0);
  EXPECT_FALSE(scene.surface);
  EXPECT_TRUE(scene.frame);
  EXPECT_FALSE(session.load(0, SessionPart::kMembranes));
  EXPECT_TRUE(session.load(1, SessionPart::kMembranes));
  EXPECT_THROW(session.load(2), std::out_of_range);
}

TEST(SessionReader, EventsComeWithTheirStep) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    for (long frame = 0; frame < 3; ++frame) writer.write(make_scene(frame));
    writer.event({time_of(1) + 0.001, "contact", "a, b"});
    writer.event({9.0, "note", "after the end"});
    writer.close();
  }
  const SessionReader session(folder / "s");
  ASSERT_EQ(session.events().size(), 2U);
  EXPECT_EQ(session.events()[0].detail, "a, b");
  EXPECT_TRUE(session.load(0).events.empty());
  ASSERT_EQ(session.load(1).events.size(), 1U);
  EXPECT_EQ(session.load(1).events[0].kind, "contact");
  ASSERT_EQ(session.load(2).events.size(), 1U);
}

TEST(SessionReader, AFrameThatWasNotMeasuredHasNoState) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    writer.write(make_scene(0));
    writer.write(make_empty_scene(1));
    Scene lost = make_empty_scene(2);
    lost.measurement.state = CellState::kLost;
    writer.write(lost);
  }
  const SessionReader session(folder / "s");
  EXPECT_EQ(session.measurements()[0].state, CellState::kContact);
  EXPECT_FALSE(session.measurements()[1].state);
  EXPECT_EQ(session.measurements()[2].state, CellState::kLost);
  EXPECT_EQ(check_session(folder / "s", false).counts.unmeasured_count, 1U);
}

// A recording that was cut off was never put in order: its reader and its repair do so.
TEST(SessionReader, EventsComeInTheOrderOfTime) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    writer.event({0.5, "limit", "depth"});
    writer.event({0.1, "contact", ""});
  }
  EXPECT_EQ(SessionReader(folder / "s").events()[0].kind, "contact");
  EXPECT_EQ(rows_of(folder / "s/events.csv")[1], "0.5,limit,depth");
  check_session(folder / "s", true);
  EXPECT_EQ(rows_of(folder / "s/events.csv")[1], "0.1,contact,");
}

TEST(SessionReader, PassesOverATornRow) {
  const TemporaryFolder folder;
  write_session(folder / "s", 3);
  const fs::path table = folder / "s/measurements.csv";
  fs::resize_file(table, fs::file_size(table) - 4);
  EXPECT_EQ(SessionReader(folder / "s").steps().size(), 2U);
}

TEST(SessionReader, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const auto expect_error = [](const fs::path& path, const std::string& part) {
    try {
      const SessionReader session(path);
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  expect_error(folder / "nowhere", "no such session folder");
  put(folder / "file", "text");
  expect_error(folder / "file", "no such session folder");
  fs::create_directories(folder / "empty");
  expect_error(folder / "empty", "no session here");
  write_session(folder / "s", 1);
  put(folder / "s/session.json", "{ torn");
  expect_error(folder / "s", "session.json: not JSON");
}

TEST(SessionReader, DamagedFileIsAnInputError) {
  const TemporaryFolder folder;
  write_session(folder / "s", 2);
  const fs::path file = folder / "s/surface/surface_00000001.vtp";
  fs::resize_file(file, fs::file_size(file) / 2);
  const SessionReader session(folder / "s");
  EXPECT_NO_THROW(session.load(0));
  EXPECT_THROW(session.load(1), InputError);
}

}  // namespace
}  // namespace pellucida
