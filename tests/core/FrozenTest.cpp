#include "pellucida/core_vtk/Frozen.h"
#include "pellucida/core_vtk/OwnArrays.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <string>
#include <thread>
#include <vector>

#include "pellucida/core/SharedLatest.h"

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

// What a reader or writer asks for first, VTK would otherwise make in an object that several threads hold.
TEST(Frozen, LeavesNothingToBeMadeLater) {
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 4; ++i) points->InsertNextPoint(i % 2, i / 2, 0);
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({0, 1, 3, 2});
  vtkNew<vtkStringArray> words;
  words->SetName("provenance");
  words->InsertNextValue("seen");
  vtkNew<vtkFloatArray> force_uN;
  force_uN->SetName("force_uN");
  for (int i = 0; i < 4; ++i) force_uN->InsertNextValue(static_cast<float>(i));
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(faces);
  data->GetPointData()->AddArray(force_uN);
  data->GetFieldData()->AddArray(words);
  const Frozen<vtkPolyData> frozen(data);

  const auto keys = [](vtkAbstractArray* array) {
    return array->HasInformation() ? array->GetInformation()->GetNumberOfKeys() : -1;
  };
  const std::vector<vtkAbstractArray*> arrays{points->GetData(), faces->GetOffsetsArray(),
                                              faces->GetConnectivityArray(), force_uN, words};
  std::vector<int> before;
  for (vtkAbstractArray* array : arrays) before.push_back(keys(array));
  for (const int count : before) EXPECT_GE(count, 0);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(frozen.shallow_copy());
  writer->SetDataModeToAppended();
  writer->SetWriteToOutputString(true);
  ASSERT_EQ(writer->Write(), 1);
  for (std::size_t i = 0; i < arrays.size(); ++i) EXPECT_EQ(keys(arrays[i]), before[i]) << "array " << i;
}

// As sessions of several variants are written, from the same parts at the same time.
TEST(Frozen, WritersInSeveralThreadsWriteTheSame) {
  for (int round = 0; round < 200; ++round) {
    const auto frozen = frozen_points(20);
    std::vector<std::string> written(3);
    {
      std::vector<std::jthread> writers;
      for (std::string& text : written) {
        writers.emplace_back([&frozen, &text] {
          vtkNew<vtkXMLPolyDataWriter> writer;
          const auto copy = frozen.shallow_copy();
          give_own_arrays(copy);
          writer->SetInputData(copy);
          writer->SetWriteToOutputString(true);
          writer->Write();
          text = writer->GetOutputString();
        });
      }
    }
    ASSERT_FALSE(written[0].empty());
    for (const std::string& text : written) ASSERT_EQ(text, written[0]) << "round " << round;
  }
}

// Handles come and go in many threads at once, as scenes do between stages: no thread may walk into another's deletion.
TEST(Frozen, HandlesMayBeDroppedInAnyThread) {
  SharedLatest<Frozen<vtkPolyData>> newest;
  std::vector<std::jthread> readers;
  for (int reader = 0; reader < 3; ++reader) {
    readers.emplace_back([&newest] {
      while (auto frozen = newest.wait({})) {
        auto second = *frozen;
        frozen.reset();
        second.shallow_copy();
      }
    });
  }
  for (int i = 0; i < 20000; ++i) newest.publish(frozen_points(2));
  newest.close();
}

}  // namespace
}  // namespace pellucida
