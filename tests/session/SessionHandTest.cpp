// The recording of the hand: written in blocks, read back, checked, mended, exported.
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>

#include <nlohmann/json.hpp>

#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionExport.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {
namespace {

using namespace test;

// Hand and tip over three ticks; numbers depend on the block.
Frozen<vtkPolyData> make_block(int block) {
  constexpr int kTickCount = 3;
  auto paths = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> path;
  path->SetName("path");
  vtkNew<vtkDoubleArray> time;
  time->SetName("time_s");
  vtkNew<vtkFloatArray> force;
  force->SetName("force_N");
  force->SetNumberOfComponents(3);
  for (int line = 0; line < 2; ++line) {
    lines->InsertNextCell(kTickCount);
    for (int tick = 0; tick < kTickCount; ++tick) {
      lines->InsertCellPoint(points->InsertNextPoint(line, tick, block));
      time->InsertNextValue(block + 0.001 * tick);
      force->InsertNextTuple3(0.5, 0.25, tick);
    }
    path->InsertNextValue(line);
  }
  paths->SetPoints(points);
  paths->SetLines(lines);
  paths->GetCellData()->AddArray(path);
  paths->GetPointData()->AddArray(time);
  paths->GetPointData()->AddArray(force);
  return Frozen<vtkPolyData>(paths);
}

class SessionHand : public testing::Test {
 protected:
  void SetUp() override {
    SessionWriter writer(session(), make_info());
    for (int block = 0; block < 2; ++block) writer.write_hand(make_block(block), block);
    writer.set_plan(R"({"depth_stop_um": 44})");
    writer.close();
  }
  fs::path session() const { return folder_ / "s"; }
  fs::path output() const { return folder_ / "x"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(SessionHand, ComesBackAsItWasWritten) {
  const SessionReader reader(session());
  ASSERT_EQ(reader.hand_block_count(), 2U);
  EXPECT_EQ(reader.stated_counts().hand_block_count, 2U);
  const auto block = reader.load_hand(1).shallow_copy();
  EXPECT_EQ(block->GetNumberOfCells(), 2);
  EXPECT_EQ(block->GetNumberOfPoints(), 6);
  EXPECT_DOUBLE_EQ(block->GetPointData()->GetArray("time_s")->GetComponent(2, 0), 1.002);
  EXPECT_DOUBLE_EQ(stamped_time_s(block), 1.0);
  EXPECT_EQ(stamped_frame_index(block), 1);
  EXPECT_THROW(reader.load_hand(2), std::out_of_range);
}

TEST_F(SessionHand, ThePlanIsKept) {
  const auto plan = nlohmann::json::parse(SessionReader(session()).info().plan_json);
  EXPECT_EQ(plan["depth_stop_um"], 44);
}

TEST_F(SessionHand, AWholeOneIsFine) {
  const SessionReport report = check_session(session(), false);
  EXPECT_TRUE(report.fine()) << (report.problems.empty() ? "" : report.problems.front());
  EXPECT_EQ(report.counts.hand_block_count, 2U);
}

TEST_F(SessionHand, ATornBlockIsNamedAndPutAside) {
  fs::resize_file(session() / "haptics/haptics_00000001.vtp", 100);
  const SessionReport damaged = check_session(session(), false);
  EXPECT_FALSE(damaged.fine());
  EXPECT_NE(damaged.problems.front().find("haptics/haptics_00000001.vtp"), std::string::npos);

  EXPECT_TRUE(check_session(session(), true).repaired);
  EXPECT_TRUE(check_session(session(), false).fine());
  EXPECT_TRUE(fs::exists(session() / "damaged/haptics_00000001.vtp"));
  EXPECT_EQ(SessionReader(session()).hand_block_count(), 1U);
}

TEST_F(SessionHand, AMissingBlockIsMissed) {
  fs::remove(session() / "haptics/haptics_00000000.vtp");
  const SessionReport report = check_session(session(), false);
  EXPECT_FALSE(report.fine());
  EXPECT_TRUE(mentions(report.problems, "files of the hand"));
  EXPECT_TRUE(mentions(report.problems, "the first haptics/haptics_00000000.vtp"));
}

TEST_F(SessionHand, IsExportedWithAllItsArrays) {
  const ExportReport report = export_session(session(), output());
  const auto rows = lines_of(output() / "haptics.csv");
  ASSERT_EQ(rows.size(), 13U);
  EXPECT_EQ(report.hand_row_count, 12U);
  EXPECT_EQ(rows[0], "path,x_um,y_um,z_um,time_s,force_N_x,force_N_y,force_N_z");
  EXPECT_EQ(rows[1], "hand,0,0,0,0,0.5,0.25,0");
  EXPECT_EQ(rows[12], "tip,1,2,1,1.002,0.5,0.25,2");
}

}  // namespace
}  // namespace pellucida
