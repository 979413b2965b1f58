#include "pellucida/visualization_vtk/MessageLog.h"

#include <gtest/gtest.h>
#include <vtkSmartPointer.h>

#include <string>

namespace pellucida {
namespace {

TEST(MessageLog, KeepsOneLineWithoutPlaceAndAddress) {
  const auto log = vtkSmartPointer<MessageLog>::New();
  log->DisplayErrorText("ERROR: In /build/vtkThing.cxx, line 12\nvtkThing (0x55d0c0ffee00): no input\nat port 0\n\n");
  EXPECT_EQ(log->last_problem(), "vtkThing: no input at port 0");
  EXPECT_EQ(log->problem_count(), 1U);
}

TEST(MessageLog, PrintsARepeatedMessageOnceAndCountsAll) {
  const auto log = vtkSmartPointer<MessageLog>::New();
  testing::internal::CaptureStderr();
  for (int i = 0; i < 500; ++i) {
    const std::string address = std::to_string(1000 + i);
    log->DisplayWarningText(("Warning: In a.cxx, line 1\nvtkThing (0x" + address + "): odd\n").c_str());
  }
  log->DisplayWarningText("");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "vtk warning: vtkThing: odd\n");
  EXPECT_EQ(log->problem_count(), 500U);
}

}  // namespace
}  // namespace pellucida
