#include "pellucida/vtk_files/SurfacePrecision.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <cmath>
#include <limits>
#include <random>

#include "pellucida/core_vtk/SceneData.h"
#include "session/SameData.h"

namespace pellucida {
namespace {

using namespace test;

constexpr vtkIdType kNodes = 500;

vtkDataArray* add(vtkPolyData* surface, const char* name, int components, double least, double most) {
  static std::mt19937 random(11);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(kNodes);
  std::uniform_real_distribution<double> number(least, most);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) array->SetValue(i, number(random));
  surface->GetPointData()->AddArray(array);
  return surface->GetPointData()->GetArray(name);
}

vtkSmartPointer<vtkPolyData> nodes(bool with_sigma) {
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < kNodes; ++i)
    points->InsertNextPoint(300.0 + 0.1237 * static_cast<double>(i), 1.0 / 3.0, -7.7);
  surface->SetPoints(points);
  add(surface, array_name::kDisplacement, 3, -30.0, 30.0);
  add(surface, array_name::kRestDirection, 3, -1.0, 1.0);
  add(surface, array_name::kForce, 3, -0.05, 0.05);
  if (with_sigma) add(surface, array_name::kForceSigma, 1, 1e-6, 0.01);
  add(surface, array_name::kNeedleForce, 3, -0.05, 0.05);
  add(surface, array_name::kHolderForce, 3, -0.05, 0.05);
  add(surface, array_name::kTension, 1, -0.02, 0.03);
  add(surface, array_name::kAreaStrain, 1, -20.0, 60.0);
  add(surface, "of_another_kind", 2, 0.0, 1.0);
  return surface;
}

double largest_change(vtkPolyData* before, vtkPolyData* after, const char* name) {
  vtkDataArray* one = before->GetPointData()->GetArray(name);
  vtkDataArray* other = after->GetPointData()->GetArray(name);
  double largest = 0.0;
  for (vtkIdType i = 0; i < kNodes; ++i) {
    for (int j = 0; j < one->GetNumberOfComponents(); ++j) {
      largest = std::max(largest, std::abs(one->GetComponent(i, j) - other->GetComponent(i, j)));
    }
  }
  return largest;
}

TEST(SurfacePrecision, RoundsWithinItsSteps) {
  const auto surface = nodes(true);
  const auto narrow = narrowed_surface(surface);
  for (const char* name :
       {array_name::kDisplacement, array_name::kRestDirection, array_name::kForce, array_name::kForceSigma,
        array_name::kTension, array_name::kNeedleForce, array_name::kHolderForce, array_name::kAreaStrain}) {
    EXPECT_EQ(narrow->GetPointData()->GetArray(name)->GetDataType(), VTK_FLOAT) << name;
  }
  for (vtkIdType i = 0; i < kNodes; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(surface->GetPoint(i)[j], narrow->GetPoint(i)[j], 0.00196);
  }
  EXPECT_LE(largest_change(surface, narrow, array_name::kDisplacement), 0.00196);
  EXPECT_LE(largest_change(surface, narrow, array_name::kRestDirection), 0.0000612);
  vtkDataArray* sigma = surface->GetPointData()->GetArray(array_name::kForceSigma);
  for (vtkIdType i = 0; i < kNodes; ++i) {
    const double sigma_uN = sigma->GetComponent(i, 0);
    for (int j = 0; j < 3; ++j) {
      for (const char* name : {array_name::kForce, array_name::kNeedleForce, array_name::kHolderForce}) {
        EXPECT_NEAR(surface->GetPointData()->GetArray(name)->GetComponent(i, j),
                    narrow->GetPointData()->GetArray(name)->GetComponent(i, j), 1.01 * sigma_uN / 64.0);
      }
    }
    EXPECT_NEAR(narrow->GetPointData()->GetArray(array_name::kForceSigma)->GetComponent(i, 0), sigma_uN,
                0.001 * sigma_uN);
    const double tension = surface->GetPointData()->GetArray(array_name::kTension)->GetComponent(i, 0);
    EXPECT_NEAR(narrow->GetPointData()->GetArray(array_name::kTension)->GetComponent(i, 0), tension,
                0.001 * std::abs(tension));
  }
}

TEST(SurfacePrecision, NarrowingTwiceIsNarrowingOnce) {
  const auto once = narrowed_surface(nodes(true));
  expect_same(once, narrowed_surface(once));
}

TEST(SurfacePrecision, ForcesAloneAreNarrowedLikeAllOfIt) {
  const auto surface = nodes(true);
  const auto narrow = narrowed_surface(surface);
  vtkNew<vtkPolyData> forces;
  forces->ShallowCopy(surface);
  narrow_forces(forces);
  for (const char* name : {array_name::kForce, array_name::kForceSigma, array_name::kTension, array_name::kNeedleForce,
                           array_name::kHolderForce, array_name::kAreaStrain}) {
    EXPECT_EQ(largest_change(narrow, forces, name), 0.0) << name;
    EXPECT_EQ(forces->GetPointData()->GetArray(name)->GetDataType(), VTK_FLOAT) << name;
  }
  EXPECT_EQ(largest_change(surface, forces, array_name::kDisplacement), 0.0);
  EXPECT_EQ(surface->GetPointData()->GetArray(array_name::kForce)->GetDataType(), VTK_DOUBLE);
}

TEST(SurfacePrecision, LeavesTheRestAndTheOriginalAlone) {
  const auto surface = nodes(true);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(surface);
  const auto narrow = narrowed_surface(surface);
  expect_same(before.Get(), surface);
  EXPECT_EQ(largest_change(surface, narrow, "of_another_kind"), 0.0);
  EXPECT_EQ(narrow->GetPointData()->GetNumberOfArrays(), surface->GetPointData()->GetNumberOfArrays());
}

TEST(SurfacePrecision, AForceWithoutADeviationKeepsItsDigits) {
  const auto surface = nodes(false);
  EXPECT_LT(largest_change(surface, narrowed_surface(surface), array_name::kForce), 4e-9);
  vtkDataArray* sigma = add(surface, array_name::kForceSigma, 1, 0.0, 0.0);
  sigma->SetComponent(3, 0, std::numeric_limits<double>::infinity());
  EXPECT_LT(largest_change(surface, narrowed_surface(surface), array_name::kForce), 4e-9);
}

TEST(SurfacePrecision, WhatIsNoNumberStaysNone) {
  const auto surface = nodes(true);
  surface->GetPointData()->GetArray(array_name::kForce)->SetComponent(2, 1, std::nan(""));
  surface->GetPointData()->GetArray(array_name::kTension)->SetComponent(2, 0, -HUGE_VAL);
  const auto narrow = narrowed_surface(surface);
  EXPECT_TRUE(std::isnan(narrow->GetPointData()->GetArray(array_name::kForce)->GetComponent(2, 1)));
  EXPECT_EQ(narrow->GetPointData()->GetArray(array_name::kTension)->GetComponent(2, 0), -HUGE_VAL);
}

}  // namespace
}  // namespace pellucida
