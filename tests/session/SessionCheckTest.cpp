#include "pellucida/session/SessionCheck.h"

#include <nlohmann/json.hpp>

#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {
namespace {

using namespace test;

class SessionCheck : public testing::Test {
 protected:
  void SetUp() override { write_session(session(), 5); }
  fs::path session() const { return folder_ / "s"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(SessionCheck, WholeSessionIsFine) {
  std::size_t last_done = 0;
  std::size_t last_total = 0;
  const SessionReport report = check_session(session(), false, [&](std::size_t done, std::size_t total) {
    last_done = done;
    last_total = total;
  });
  EXPECT_TRUE(report.fine()) << testing::PrintToString(report.problems);
  EXPECT_EQ(report.counts.step_count, 5U);
  EXPECT_EQ(report.counts.files(SessionPart::kTools), 5U);
  EXPECT_EQ(report.counts.event_count, 1U);
  EXPECT_EQ(last_done, 20U);
  EXPECT_EQ(last_total, 20U);
  EXPECT_EQ(report.counts.byte_count, SessionReader(session()).stated_counts().byte_count);
}

TEST_F(SessionCheck, RepairOfAWholeSessionChangesNothing) {
  const std::string before = text_of(session() / "session.json");
  EXPECT_TRUE(check_session(session(), true).repairs.empty());
  EXPECT_EQ(text_of(session() / "session.json"), before);
}

TEST_F(SessionCheck, MendsATornLastRow) {
  const fs::path table = session() / "measurements.csv";
  fs::resize_file(table, fs::file_size(table) - 3);
  expect_mended(session(), "measurements.csv:6: cut off");
  EXPECT_EQ(lines_of(table).size(), 5U);
  EXPECT_TRUE(mentions(lines_of(session() / "damaged/lines.txt"), "measurements.csv:6: 4,0.133333333,"));
  // The files of the row that was lost are kept.
  EXPECT_TRUE(fs::exists(session() / "surface/surface_00000004.vtp"));
  EXPECT_TRUE(mentions(check_session(session(), false).notes, "belong to no row"));
}

TEST_F(SessionCheck, MendsARowInTheMiddle) {
  const fs::path table = session() / "measurements.csv";
  std::string text = text_of(table);
  text.replace(text.find("\n2,"), 3, "\n2?");
  put(table, text);
  expect_mended(session(), "measurements.csv:4");
  EXPECT_EQ(SessionReader(session()).steps().size(), 4U);
}

TEST_F(SessionCheck, FindsARowOfZeros) {
  std::ofstream(session() / "measurements.csv", std::ios::app) << std::string(100, '\0');
  expect_mended(session(), "measurements.csv:7");
}

TEST_F(SessionCheck, MendsATornEvent) {
  std::ofstream(session() / "events.csv", std::ios::app) << "0.2,pun";
  expect_mended(session(), "events.csv:3");
  EXPECT_EQ(SessionReader(session()).events().size(), 1U);
}

TEST_F(SessionCheck, MovesACutOffFileAside) {
  const fs::path file = session() / "surface/surface_00000004.vtp";
  const auto half = fs::file_size(file) / 2;
  fs::resize_file(file, half);
  expect_mended(session(), "surface/surface_00000004.vtp: cut off before its end");
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(fs::file_size(session() / "damaged/surface_00000004.vtp"), half);
  const SessionReader reader(session());
  EXPECT_FALSE(reader.steps()[4].has(SessionPart::kSurface));
  EXPECT_TRUE(reader.steps()[4].has(SessionPart::kMembranes));
  EXPECT_EQ(reader.stated_counts().files(SessionPart::kSurface), 4U);
}

TEST_F(SessionCheck, MovesAnEmptyAndAGarbledFileAside) {
  fs::resize_file(session() / "frames/frame_00000001.vti", 0);
  put(session() / "tools/tools_00000002.vtp", "<VTKFile type=\"PolyData\"><oops></VTKFile>\n");
  expect_mended(session(), "frames/frame_00000001.vti");
  EXPECT_TRUE(fs::exists(session() / "damaged/tools_00000002.vtp"));
}

TEST_F(SessionCheck, FindsAFileUnderAWrongName) {
  fs::copy_file(session() / "surface/surface_00000001.vtp", session() / "surface/surface_00000003.vtp",
                fs::copy_options::overwrite_existing);
  expect_mended(session(), "surface/surface_00000003.vtp: stamped as frame 1");
}

TEST_F(SessionCheck, FindsAMissingFile) {
  fs::remove(session() / "membranes/membranes_00000002.vtp");
  expect_mended(session(), "session.pvd: lists 1 file(s) that are not there");
}

TEST_F(SessionCheck, MakesTheListAnew) {
  const std::string whole = text_of(session() / "session.pvd");
  put(session() / "session.pvd", whole.substr(0, whole.size() / 2));
  expect_mended(session(), "session.pvd: not readable");
  EXPECT_EQ(text_of(session() / "session.pvd"), whole);
  fs::remove(session() / "session.pvd");
  expect_mended(session(), "session.pvd is missing");
  EXPECT_EQ(text_of(session() / "session.pvd"), whole);
}

TEST_F(SessionCheck, RemovesUnfinishedFiles) {
  put(session() / "surface/surface_00000005.vtp.tmp", "half");
  put(session() / "session.json.tmp", "half");
  expect_mended(session(), "2 unfinished temporary file(s)");
  EXPECT_FALSE(fs::exists(session() / "surface/surface_00000005.vtp.tmp"));
}

TEST_F(SessionCheck, CountsMustBeRight) {
  std::string text = text_of(session() / "session.json");
  text.replace(text.find("\"steps\": 5"), 10, "\"steps\": 6");
  put(session() / "session.json", text);
  expect_mended(session(), "session.json: says 6 steps, there are 5");
}

TEST_F(SessionCheck, MakesALostHeadAnew) {
  put(session() / "session.json", "{ \"schema");
  expect_mended(session(), "session.json");
  EXPECT_EQ(text_of(session() / "damaged/session.json"), "{ \"schema");
  const SessionReader reader(session());
  EXPECT_FALSE(reader.complete());
  EXPECT_EQ(reader.info().source.pixel_size_um, 0.825);
  EXPECT_EQ(reader.steps().size(), 5U);
}

TEST_F(SessionCheck, RepairedSessionStaysMarkedAsCutOff) {
  std::string text = text_of(session() / "session.json");
  text.replace(text.find("\"complete\": true"), 16, "\"complete\": false");
  put(session() / "session.json", text);
  expect_mended(session(), "cut off");
  const auto head = nlohmann::json::parse(text_of(session() / "session.json"));
  EXPECT_EQ(head["complete"], false);
  EXPECT_EQ(head["recovered"], true);
  EXPECT_EQ(head["source"]["name"], "a video.avi");
}

// What a power cut in the middle of a frame leaves: no close, a file cut short, a torn row, a temporary file.
TEST(SessionCrash, IsMendedWithTheLossOfOneStepOnly) {
  const TemporaryFolder folder;
  const fs::path session = folder / "s";
  {
    SessionWriter writer(session, make_info());
    for (long frame = 0; frame < 10; ++frame) writer.write(make_scene(frame));
  }
  fs::resize_file(session / "frames/frame_00000009.vti", 50);
  fs::resize_file(session / "measurements.csv", fs::file_size(session / "measurements.csv") - 10);
  put(session / "surface/surface_00000010.vtp.tmp", "<VTKFile");
  expect_mended(session, "the recording was cut off");
  const SessionReader reader(session);
  ASSERT_EQ(reader.steps().size(), 9U);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_TRUE(reader.steps()[i].has(SessionPart::kSurface));
    EXPECT_NO_THROW(reader.load(i));
  }
}

TEST(SessionCrash, RightAfterTheStartIsMendedToo) {
  const TemporaryFolder folder;
  { const SessionWriter writer(folder / "s", make_info()); }
  expect_mended(folder / "s", "the recording was cut off");
}

TEST(SessionCheckErrors, NoSessionIsAnInputError) {
  const TemporaryFolder folder;
  EXPECT_THROW(check_session(folder / "nowhere", false), InputError);
  fs::create_directories(folder / "empty");
  EXPECT_THROW(check_session(folder / "empty", true), InputError);
  EXPECT_TRUE(fs::is_empty(folder / "empty"));
}

}  // namespace
}  // namespace pellucida
