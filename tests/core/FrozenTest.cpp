#include "pellucida/core_vtk/Frozen.h"
#include "pellucida/core_vtk/OwnArrays.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <limits>
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

// NaN counts as equal to itself.
void expect_equal(const double (&found)[2], const double (&expected)[2]) {
  for (int end = 0; end < 2; ++end) {
    EXPECT_TRUE(found[end] == expected[end] || (std::isnan(found[end]) && std::isnan(expected[end])))
        << found[end] << " for " << expected[end];
  }
}

// Ranges are found without VTK: they are those that VTK finds.
template <class Array>
void expect_ranges_of_vtk(int component_count, const std::vector<double>& values) {
  const auto make = [&] {
    auto array = vtkSmartPointer<Array>::New();
    array->SetNumberOfComponents(component_count);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / component_count);
    for (std::size_t i = 0; i < values.size(); ++i) {
      array->SetValue(static_cast<vtkIdType>(i), static_cast<typename Array::ValueType>(values[i]));
    }
    return array;
  };
  const auto ours = make(), of_vtk = make();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->GetPointData()->AddArray(ours);
  const Frozen<vtkPolyData> frozen(data);
  const int keys = ours->GetInformation()->GetNumberOfKeys();
  for (int component = -1; component < component_count; ++component) {
    double found[2], expected[2];
    ours->GetRange(found, component);
    of_vtk->GetRange(expected, component);
    expect_equal(found, expected);
    ours->GetFiniteRange(found, component);
    of_vtk->GetFiniteRange(expected, component);
    expect_equal(found, expected);
  }
  EXPECT_EQ(ours->GetInformation()->GetNumberOfKeys(), keys) << "VTK found them again";
}

TEST(Frozen, RangesAreThoseOfVtk) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  const std::vector<double> plain{3.1, -2.7, 0.4, 11.2, 5.5, -9.3},
      odd{kNan, 1.5, kInf, -4.0, 2.5, -kInf, 0.5, kNan, 7.0};
  for (const int components : {1, 3}) {
    expect_ranges_of_vtk<vtkDoubleArray>(components, plain);
    expect_ranges_of_vtk<vtkFloatArray>(components, plain);
    expect_ranges_of_vtk<vtkIntArray>(components, plain);
    expect_ranges_of_vtk<vtkTypeInt64Array>(components, plain);
    expect_ranges_of_vtk<vtkUnsignedCharArray>(components, {3, 250, 4});
    expect_ranges_of_vtk<vtkDoubleArray>(components, odd);
    expect_ranges_of_vtk<vtkFloatArray>(components, odd);
    expect_ranges_of_vtk<vtkDoubleArray>(components, {kNan, kNan, kNan});
    expect_ranges_of_vtk<vtkDoubleArray>(components, {});
  }
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
