#include "HandDeposits.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/haptics/HapticRecord.h"

namespace pellucida {
namespace {

// Ticks of a millisecond from `begin_s`, as one path; `inject` and `works` by number of the tick.
vtkSmartPointer<vtkPolyData> ticks(double begin_s, int count, const std::function<bool(int)>& inject, HandState state) {
  auto paths = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> time;
  vtkNew<vtkIntArray> buttons, states;
  time->SetName("time_s");
  buttons->SetName("buttons");
  states->SetName("hand_state");
  lines->InsertNextCell(count);
  for (int i = 0; i < count; ++i) {
    lines->InsertCellPoint(points->InsertNextPoint(0.0, 0.0, 0.0));
    time->InsertNextValue(begin_s + 0.001 * i);
    buttons->InsertNextValue(inject(i) ? static_cast<int>(kInject | kClutch) : static_cast<int>(kRetract));
    states->InsertNextValue(static_cast<int>(state));
  }
  paths->SetPoints(points);
  paths->SetLines(lines);
  for (vtkDataArray* array :
       {static_cast<vtkDataArray*>(time), static_cast<vtkDataArray*>(buttons), static_cast<vtkDataArray*>(states)}) {
    paths->GetPointData()->AddArray(array);
  }
  return paths;
}

TEST(HandDeposits, StretchesGoOnFromBlockToBlock) {
  DepositFinder finder;
  finder.add(ticks(
      1.0, 1000, [](int i) { return i >= 800; }, HandState::kWorking));
  finder.add(ticks(
      2.0, 1000, [](int i) { return i < 300 || i >= 900; }, HandState::kWorking));
  ASSERT_EQ(finder.deposits().size(), 2U);
  EXPECT_NEAR(finder.deposits()[0].begin_s, 1.8, 1e-9);
  EXPECT_NEAR(finder.deposits()[0].end_s, 2.299, 1e-9);
  EXPECT_NEAR(finder.deposits()[1].begin_s, 2.9, 1e-9);
}

TEST(HandDeposits, AHandThatDoesNotWorkDepositsNothing) {
  DepositFinder finder;
  finder.add(ticks(
      1.0, 100, [](int) { return true; }, HandState::kClutched));
  finder.add(ticks(
      2.0, 100, [](int) { return false; }, HandState::kWorking));
  finder.add(vtkSmartPointer<vtkPolyData>::New());
  EXPECT_TRUE(finder.deposits().empty());
}

}  // namespace
}  // namespace pellucida
