#include "ToolShapes.h"

#include <gtest/gtest.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkTriangleFilter.h>

#include <Eigen/LU>

#include "visualization/SyntheticScene.h"

namespace pellucida {
namespace {

TEST(ToolShapes, NeedleReadBackFromItsOutlineIsTheOneObserved) {
  Scene scene = test::synthetic_scene(20.0);
  const auto observed = needle_of(scene);
  scene.observation.reset();
  const auto read = needle_of(scene);
  ASSERT_TRUE(observed && read);
  EXPECT_NEAR((observed->tip_um - read->tip_um).norm(), 0.0, 1e-4);
  EXPECT_GT(observed->direction.dot(read->direction), 0.99999);
}

TEST(ToolShapes, NoToolsNoNeedle) {
  EXPECT_FALSE(needle_of(Scene{}).has_value());
  EXPECT_FALSE(holder_of(Scene{}).has_value());
}

TEST(ToolShapes, NeedleProfileStartsClosedAndNeverThins) {
  const Scene scene = test::synthetic_scene(20.0);
  const auto profile = needle_profile(*needle_of(scene), 100.0);
  EXPECT_EQ(profile.front().radius_um, 0.0);
  EXPECT_NEAR(profile.back().along_um, 100.0, 1e-9);
  for (std::size_t i = 1; i < profile.size(); ++i) {
    EXPECT_GT(profile[i].along_um, profile[i - 1].along_um);
    EXPECT_GE(profile[i].radius_um, profile[i - 1].radius_um);
  }
}

TEST(ToolShapes, ARevolvedConeHasAConesVolume) {
  constexpr double kRadius_um = 6.0;
  constexpr double kLength_um = 30.0;
  const auto cone =
      revolve_profile({{0.0, 0.0}, {kLength_um, kRadius_um}, {kLength_um, 0.0}}, {10.0, 20.0}, {1.0, 0.0});
  // The sum of the tetrahedra from the origin to each triangle: positive when the faces look outward.
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(cone);
  triangles->Update();
  double volume_um3 = 0.0;
  for (vtkIdType cell = 0; cell < triangles->GetOutput()->GetNumberOfCells(); ++cell) {
    vtkNew<vtkIdList> ids;
    triangles->GetOutput()->GetCellPoints(cell, ids);
    Eigen::Matrix3d corners_um;
    for (int k = 0; k < 3; ++k) triangles->GetOutput()->GetPoint(ids->GetId(k), corners_um.col(k).data());
    volume_um3 += corners_um.determinant() / 6.0;
  }
  const double expected_um3 = EIGEN_PI * kRadius_um * kRadius_um * kLength_um / 3.0;
  // A 28-sided cone holds 0.8 % less than a round one.
  EXPECT_NEAR(volume_um3, expected_um3, 0.012 * expected_um3);
}

}  // namespace
}  // namespace pellucida
