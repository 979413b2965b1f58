#pragma once
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkVariant.h>

#include <algorithm>

namespace pellucida::test {

/// The same arrays, by name, type and number; in any order.
inline void expect_same_arrays(vtkFieldData* left, vtkFieldData* right) {
  ASSERT_EQ(left->GetNumberOfArrays(), right->GetNumberOfArrays());
  for (int i = 0; i < left->GetNumberOfArrays(); ++i) {
    vtkDataArray* one = left->GetArray(i);
    vtkDataArray* other = right->GetArray(one->GetName());
    ASSERT_TRUE(other) << one->GetName();
    EXPECT_EQ(one->GetDataType(), other->GetDataType()) << one->GetName();
    ASSERT_EQ(one->GetNumberOfValues(), other->GetNumberOfValues()) << one->GetName();
    for (vtkIdType k = 0; k < one->GetNumberOfValues(); ++k) {
      EXPECT_EQ(one->GetVariantValue(k), other->GetVariantValue(k)) << one->GetName() << " value " << k;
    }
  }
}

/// The same points, cells and arrays, to the bit.
inline void expect_same(vtkSmartPointer<vtkPolyData> left, vtkSmartPointer<vtkPolyData> right) {
  ASSERT_TRUE(left && right);
  ASSERT_EQ(left->GetNumberOfPoints(), right->GetNumberOfPoints());
  ASSERT_EQ(left->GetNumberOfCells(), right->GetNumberOfCells());
  for (vtkIdType i = 0; i < left->GetNumberOfPoints(); ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_EQ(left->GetPoint(i)[j], right->GetPoint(i)[j]);
  }
  for (vtkIdType i = 0; i < left->GetNumberOfCells(); ++i) {
    EXPECT_EQ(left->GetCellType(i), right->GetCellType(i));
    vtkIdType sizes[2];
    const vtkIdType* ids[2];
    left->GetCellPoints(i, sizes[0], ids[0]);
    right->GetCellPoints(i, sizes[1], ids[1]);
    EXPECT_TRUE(std::equal(ids[0], ids[0] + sizes[0], ids[1], ids[1] + sizes[1]));
  }
  expect_same_arrays(left->GetPointData(), right->GetPointData());
  expect_same_arrays(left->GetCellData(), right->GetCellData());
  expect_same_arrays(left->GetFieldData(), right->GetFieldData());
}

}  // namespace pellucida::test
