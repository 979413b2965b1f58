#include "pellucida/core_vtk/Frozen.h"

#include <gtest/gtest.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <thread>
#include <vector>

namespace pellucida {
namespace {

Frozen<vtkPolyData> frozen_points(int count) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto force_uN = vtkSmartPointer<vtkFloatArray>::New();
  force_uN->SetName("force_uN");
  for (int i = 0; i < count; ++i) {
    points->InsertNextPoint(i, 0, 0);
    force_uN->InsertNextValue(static_cast<float>(i));
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(force_uN);
  return Frozen<vtkPolyData>(data);
}

TEST(Frozen, AnEmptyHandleStandsForNotThere) {
  const Frozen<vtkPolyData> nothing;
  EXPECT_FALSE(nothing);
  EXPECT_EQ(nothing.shallow_copy(), nullptr);
}

TEST(Frozen, ACopySharesTheArraysAndLeavesTheFrozenDataAlone) {
  const auto frozen = frozen_points(3);
  auto copy = frozen.shallow_copy();
  auto* original = const_cast<vtkPolyData*>(frozen.get());
  EXPECT_EQ(copy->GetPointData()->GetArray("force_uN"), original->GetPointData()->GetArray("force_uN"));
  copy->GetPointData()->RemoveArray("force_uN");
  EXPECT_EQ(original->GetPointData()->GetNumberOfArrays(), 1);
}

TEST(Frozen, ManyThreadsReadAtOnce) {
  const auto frozen = frozen_points(1000);
  std::vector<double> longest(4, 0.0);
  {
    std::vector<std::jthread> threads;
    for (auto& value : longest) {
      threads.emplace_back([&frozen, &value] {
        for (int i = 0; i < 200; ++i) {
          auto copy = frozen.shallow_copy();
          double bounds[6];
          copy->GetBounds(bounds);
          value = bounds[1] + copy->GetPointData()->GetArray("force_uN")->GetRange()[1];
        }
      });
    }
  }
  for (const double value : longest) EXPECT_DOUBLE_EQ(value, 999.0 + 999.0);
}

}  // namespace
}  // namespace pellucida
