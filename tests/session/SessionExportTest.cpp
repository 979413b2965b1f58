#include "pellucida/session/SessionExport.h"

#include "TestSession.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using namespace test;

class SessionExport : public testing::Test {
 protected:
  // Frames 0 to 4; the force rises with the frame.
  void SetUp() override { write_session(folder_ / "s", 5); }
  fs::path session() const { return folder_ / "s"; }
  fs::path output() const { return folder_ / "x"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(SessionExport, CopiesTheTables) {
  const ExportReport report = export_session(session(), output());
  // Without their checksums, which are for the session alone.
  EXPECT_EQ(lines_of(output() / "measurements.csv"), rows_of(session() / "measurements.csv"));
  EXPECT_EQ(lines_of(output() / "events.csv"), rows_of(session() / "events.csv"));
  EXPECT_EQ(report.files.size(), 4U);
  EXPECT_FALSE(fs::exists(output() / "haptics.csv"));
  EXPECT_TRUE(mentions(report.notes, "no haptics.csv"));
}

TEST_F(SessionExport, ContoursHaveEachPointOnceInOrder) {
  const ExportReport report = export_session(session(), output());
  const auto rows = lines_of(output() / "contours.csv");
  EXPECT_EQ(rows[0], "frame,membrane,point,x_um,y_um");
  ASSERT_EQ(rows.size(), 1U + 5 * (12 + 10));
  EXPECT_EQ(report.contour_point_count, 5U * 22U);
  EXPECT_EQ(rows[1], "0,0,0,150,80");
  EXPECT_EQ(rows[12].substr(0, 7), "0,0,11,");
  EXPECT_EQ(rows[13], "0,1,0,140,80");
  EXPECT_EQ(rows[23], "1,0,0,151,80");
}

TEST_F(SessionExport, NodesAreThoseOfThePeak) {
  const ExportReport report = export_session(session(), output());
  const auto rows = lines_of(output() / "nodes.csv");
  EXPECT_EQ(rows[0], "frame,node,membrane,x_um,y_um,z_um,fx_uN,fy_uN,fz_uN,force_sigma_uN");
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[1], "4,0,0,0,0,0,4,5,6,2");
  EXPECT_EQ(rows[4], "4,3,1,0,0,10,34,35,36,17");
  EXPECT_EQ(report.node_frames, std::vector<long>{4});
  EXPECT_EQ(report.node_count, 4U);
}

TEST_F(SessionExport, NodesOfChosenFrames) {
  const ExportReport report = export_session(session(), output(), {.frames = "first,2,peak,last", .progress = {}});
  EXPECT_EQ(report.node_frames, (std::vector<long>{0, 2, 4}));
  EXPECT_EQ(lines_of(output() / "nodes.csv").size(), 1U + 3 * 4);
}

TEST_F(SessionExport, RefusesFramesThatAreNotThere) {
  for (const char* list : {"5", "middle", "-1", "", "1,,2"}) {
    try {
      export_session(session(), output(), {.frames = list, .progress = {}});
      FAIL() << list;
    } catch (const UsageError& error) {
      EXPECT_TRUE(std::string(error.what()).find("from 0 to 4") != std::string::npos) << error.what();
    }
    EXPECT_FALSE(fs::exists(output() / "nodes.csv")) << list;
  }
}

TEST_F(SessionExport, RefusesTheSessionItselfAsOutput) {
  const std::string before = text_of(session() / "measurements.csv");
  EXPECT_THROW(export_session(session(), session()), UsageError);
  EXPECT_EQ(text_of(session() / "measurements.csv"), before);
}

TEST_F(SessionExport, ReplacesAnEarlierExport) {
  export_session(session(), output());
  const std::string first = text_of(output() / "contours.csv");
  export_session(session(), output());
  EXPECT_EQ(text_of(output() / "contours.csv"), first);
  for (const auto& entry : fs::directory_iterator(output())) EXPECT_EQ(entry.path().extension(), ".csv");
}

TEST_F(SessionExport, UnwritableOutputIsAnOutputError) {
  put(session().parent_path() / "file", "not a folder");
  EXPECT_THROW(export_session(session(), session().parent_path() / "file"), OutputError);
}

TEST_F(SessionExport, MissingSessionIsAnInputErrorAndMakesNoFolder) {
  EXPECT_THROW(export_session(session() / "nowhere", output()), InputError);
  EXPECT_FALSE(fs::exists(output()));
}

// "peak" is the frame of the largest force; another one in its place is named, not passed off as it.
TEST(SessionExportPeak, NamesTheFrameAndWarnsWhereItIsNotTheLargestForce) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    for (long frame = 0; frame < 4; ++frame) {
      Scene scene = make_scene(frame);
      if (frame == 3) scene.surface = {};
      writer.write(scene);
    }
    writer.close();
  }
  const ExportReport report = export_session(folder / "s", folder / "x");
  EXPECT_EQ(report.node_frames, std::vector<long>{2});
  EXPECT_TRUE(mentions(report.notes, "warning: frame 3 (1.5 uN) has the largest force but no surface"));
  EXPECT_TRUE(mentions(report.notes, "the peak in nodes.csv is frame 2 (1 uN)"));

  write_session(folder / "whole", 4);
  const ExportReport whole = export_session(folder / "whole", folder / "y");
  EXPECT_EQ(whole.node_frames, std::vector<long>{3});
  EXPECT_TRUE(mentions(whole.notes, "the peak in nodes.csv is frame 3 (1.5 uN)"));
  EXPECT_FALSE(mentions(whole.notes, "warning"));
}

TEST(SessionExportEmpty, SaysWhatIsNotThere) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    writer.write(make_empty_scene(0));
  }
  const ExportReport report = export_session(folder / "s", folder / "x");
  EXPECT_EQ(lines_of(folder / "x/contours.csv").size(), 1U);
  EXPECT_EQ(lines_of(folder / "x/nodes.csv").size(), 1U);
  EXPECT_TRUE(mentions(report.notes, "no membrane was found"));
  EXPECT_TRUE(mentions(report.notes, "no surface was made"));
  EXPECT_TRUE(mentions(report.notes, "cut off"));
}

TEST(SessionExportEmpty, ArraysThatAreMissingLeaveCellsEmpty) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    Scene scene = make_scene(0);
    auto bare = scene.surface.shallow_copy();
    bare->GetPointData()->Initialize();
    scene.surface = Frozen(bare);
    writer.write(scene);
  }
  export_session(folder / "s", folder / "x");
  EXPECT_EQ(lines_of(folder / "x/nodes.csv")[2], "0,1,,10,0,0,,,,");
}

}  // namespace
}  // namespace pellucida
