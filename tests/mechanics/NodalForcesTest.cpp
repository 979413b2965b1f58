#include "pellucida/mechanics_vtk/NodalForces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ForceTransfer.h"
#include "MeasuredScenes.h"
#include "pellucida/membrane/SphereMesh.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

using testing::make_scene;
using testing::MeasuringSteps;

Eigen::Vector3d sum_of(vtkDataArray* array) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), value;
  for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n) {
    array->GetTuple(n, value.data());
    sum += value;
  }
  return sum;
}

/// Sum of the sizes of nodal forces on one side of the cell: distinguishes a push from none.
double sum_of_sizes(vtkDataArray* array) {
  double sum = 0.0;
  Eigen::Vector3d value;
  for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n) {
    array->GetTuple(n, value.data());
    sum += value.norm();
  }
  return sum;
}

class NodalForcesMesh : public ::testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(NodalForcesMesh, CarriesTheForcesToTheOuterMembraneWithTheirSum) {
  const auto [meridian_count, ring_count] = GetParam();
  const Scene scene = make_scene(12.0, 0.8, meridian_count, ring_count);
  MeasuringSteps step(load_profile("mouse-oocyte"));
  const auto out = step.process(scene);
  ASSERT_TRUE(out.has_value());

  // The row.
  const Measurement& row = out->measurement;
  EXPECT_GT(row.contact_force_uN, 0.8);
  EXPECT_LT(row.contact_force_uN, 1.6);
  EXPECT_LT(row.contact_force_lower_uN, row.contact_force_uN);
  EXPECT_GT(row.contact_force_upper_uN, row.contact_force_uN);
  EXPECT_GT(row.pressure_Pa, 0.0);
  EXPECT_GT(row.volume_um3, 5e5);

  // The model.
  const auto model = out->model.shallow_copy();
  ASSERT_TRUE(model);
  EXPECT_EQ(model->GetNumberOfPoints(), 812);
  EXPECT_EQ(model->GetNumberOfCells(), 1620);
  for (const char* name : {array_name::kForce, array_name::kDisplacement, array_name::kTension}) {
    EXPECT_TRUE(model->GetPointData()->HasArray(name)) << name;
  }
  EXPECT_EQ(stamped_frame_index(model), 15);

  // The surface: same sum, nothing on the inner membrane.
  const auto surface = out->surface.shallow_copy();
  vtkDataArray* force = surface->GetPointData()->GetArray(array_name::kForce);
  ASSERT_TRUE(force);
  EXPECT_EQ(force->GetNumberOfComponents(), 3);
  const Eigen::Vector3d model_sum = sum_of(model->GetPointData()->GetArray(array_name::kForce));
  EXPECT_LT((sum_of(force) - model_sum).norm(), 1e-9);
  EXPECT_GT(sum_of_sizes(force), row.contact_force_uN);
  vtkDataArray* membrane = surface->GetPointData()->GetArray(array_name::kMembrane);
  vtkDataArray* sigma = surface->GetPointData()->GetArray(array_name::kForceSigma);
  vtkDataArray* tension = surface->GetPointData()->GetArray(array_name::kTension);
  ASSERT_TRUE(sigma && tension);
  for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n) {
    Eigen::Vector3d value;
    force->GetTuple(n, value.data());
    EXPECT_TRUE(value.allFinite() && std::isfinite(sigma->GetTuple1(n)) && std::isfinite(tension->GetTuple1(n)));
    if (membrane->GetTuple1(n) == 1.0) {
      EXPECT_EQ(value.norm(), 0.0);
      EXPECT_EQ(sigma->GetTuple1(n), 0.0);
    }
  }

  // The input is as it was.
  EXPECT_FALSE(scene.surface.shallow_copy()->GetPointData()->HasArray(array_name::kForce));
  EXPECT_FALSE(scene.model);
}

// Needle, holder, pressure and membrane hold each other on every node.
TEST_P(NodalForcesMesh, TheToolsForcesAddUpToTheRowsAndPressurePushesOutwards) {
  const auto [meridian_count, ring_count] = GetParam();
  const Scene scene = make_scene(12.0, 0.8, meridian_count, ring_count);
  MeasuringSteps step(load_profile("mouse-oocyte"));
  const auto out = step.process(scene);
  ASSERT_TRUE(out.has_value());
  const Measurement& row = out->measurement;
  const auto surface = out->surface.shallow_copy();
  vtkPointData* data = surface->GetPointData();
  vtkDataArray* force = data->GetArray(array_name::kForce);
  vtkDataArray* needle = data->GetArray(array_name::kNeedleForce);
  vtkDataArray* holder = data->GetArray(array_name::kHolderForce);
  ASSERT_TRUE(needle && holder);
  const Eigen::Vector3d push(-scene.observation->axis.x(), -scene.observation->axis.y(), 0.0);
  const Eigen::Vector3d needle_uN = sum_of(needle);
  EXPECT_NEAR(needle_uN.dot(push), row.contact_force_uN, 1e-3 * row.contact_force_uN);
  EXPECT_NEAR((needle_uN - needle_uN.dot(push) * push).norm(), row.lateral_force_uN, 1e-3 * row.contact_force_uN);
  EXPECT_LT((needle_uN + sum_of(holder)).norm(), 5e-3 * row.contact_force_uN);
  const Eigen::Vector3d pressure_uN = -(sum_of(force) + needle_uN + sum_of(holder));
  EXPECT_LT(pressure_uN.norm(), 5e-3 * row.contact_force_uN);

  // P times the area that the liquid pushes: the wall's inner face. 3 % off on the coarsest mesh.
  const Observation& o = *scene.observation;
  double pressed_uN = 0.0;
  int outward_count = 0, pressed_count = 0;
  for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n) {
    Eigen::Vector3d f, t, h, place;
    force->GetTuple(n, f.data());
    needle->GetTuple(n, t.data());
    holder->GetTuple(n, h.data());
    surface->GetPoint(n, place.data());
    const Eigen::Vector3d pressure = -(f + t + h);
    pressed_uN += pressure.norm();
    if (pressure.norm() < 1e-9) continue;
    ++pressed_count;
    outward_count += pressure.dot(place - Eigen::Vector3d(o.center_um.x(), o.center_um.y(), 0.0)) > 0.0;
  }
  const double radius_um = o.rest_inner_radius_um;
  const double whole_uN = 1e-6 * row.pressure_Pa * 4.0 * EIGEN_PI * radius_um * radius_um;
  EXPECT_NEAR(pressed_uN, whole_uN, 0.07 * whole_uN);
  // On the dimple's far flank it points to the centre's side.
  EXPECT_GT(outward_count, 0.9 * pressed_count);

  // Stretched on the whole, for the wall is longer than it was.
  vtkDataArray* strain = data->GetArray(array_name::kAreaStrain);
  ASSERT_TRUE(strain);
  EXPECT_GT(strain->GetRange()[1], 1.0);
  EXPECT_LT(strain->GetRange()[1], 200.0);
}

// The strains of the nodes make up the whole area's change.
TEST(NodalForces, TheStrainIsThatOfTheModelsTriangles) {
  MeasuringSteps step(load_profile("mouse-oocyte"));
  const auto out = step.process(make_scene(20.0, 0.0, 12, 23));
  ASSERT_TRUE(out.has_value());
  const auto model = out->model.shallow_copy();
  vtkDataArray* moved = model->GetPointData()->GetArray(array_name::kDisplacement);
  vtkDataArray* strain = model->GetPointData()->GetArray(array_name::kAreaStrain);
  ASSERT_TRUE(strain);
  double now_um2 = 0.0, rest_um2 = 0.0, by_strain_um2 = 0.0;
  for (vtkIdType c = 0; c < model->GetNumberOfCells(); ++c) {
    vtkNew<vtkIdList> ids;
    model->GetCellPoints(c, ids);
    Eigen::Matrix3d now, rest;
    for (int k = 0; k < 3; ++k) {
      model->GetPoint(ids->GetId(k), now.col(k).data());
      Eigen::Vector3d by;
      moved->GetTuple(ids->GetId(k), by.data());
      rest.col(k) = now.col(k) - by;
    }
    const auto area_um2 = [](const Eigen::Matrix3d& p) {
      return 0.5 * (p.col(1) - p.col(0)).cross(p.col(2) - p.col(0)).norm();
    };
    now_um2 += area_um2(now);
    rest_um2 += area_um2(rest);
    for (int k = 0; k < 3; ++k) {
      by_strain_um2 += area_um2(rest) / 3.0 * (1.0 + 0.01 * strain->GetTuple1(ids->GetId(k)));
    }
  }
  EXPECT_GT(now_um2, 1.01 * rest_um2);
  EXPECT_NEAR(by_strain_um2, now_um2, 1e-9 * now_um2);
}

// At rest there is nothing to change from.
TEST(NodalForces, ACellAtRestBearsNoForceAndNoStrain) {
  MeasuringSteps step(load_profile("mouse-oocyte"));
  // Also after a touch.
  ASSERT_TRUE(step.process(make_scene(12.0, 0.0, 12, 23)).has_value());
  const auto out = step.process(make_scene(0.0, 0.0, 12, 23));
  ASSERT_TRUE(out.has_value());
  const auto surface = out->surface.shallow_copy();
  for (const char* name : {array_name::kForce, array_name::kNeedleForce, array_name::kHolderForce, array_name::kTension,
                           array_name::kAreaStrain}) {
    vtkDataArray* array = surface->GetPointData()->GetArray(name);
    ASSERT_TRUE(array) << name;
    for (int k = 0; k < array->GetNumberOfComponents(); ++k) {
      EXPECT_NEAR(array->GetRange(k)[0], 0.0, 1e-9) << name;
      EXPECT_NEAR(array->GetRange(k)[1], 0.0, 1e-9) << name;
    }
  }
}

// The paper's steps of 60 and 30 degrees, and finer ones.
INSTANTIATE_TEST_SUITE_P(Steps, NodalForcesMesh,
                         ::testing::Values(std::tuple(6, 11), std::tuple(12, 23), std::tuple(36, 47)));

TEST(ForceTransfer, KeepsSumsAndReproducesLinearFields) {
  const TriangleMesh mesh = make_sphere_mesh(1.0, {7, 1.25});
  const TriangleMesh fine = make_sphere_mesh(1.0, {11, 1.0});
  const Eigen::VectorXd areas = node_areas_um2(fine.points_um, fine.triangles);
  const ForceTransfer transfer(mesh.points_um, mesh.triangles, fine.points_um, areas);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(mesh.points_um.cols());
  EXPECT_LT(
      (Eigen::RowVectorXd::Ones(fine.points_um.cols()) * transfer.extensive() - ones.transpose()).cwiseAbs().maxCoeff(),
      1e-12);
  EXPECT_LT((transfer.intensive() * ones - Eigen::VectorXd::Ones(fine.points_um.cols())).cwiseAbs().maxCoeff(), 1e-12);
  // A smooth field comes over as it is.
  const Eigen::VectorXd field = (mesh.points_um.row(0) + 0.5 * mesh.points_um.row(2)).transpose();
  const Eigen::VectorXd expected = (fine.points_um.row(0) + 0.5 * fine.points_um.row(2)).transpose();
  EXPECT_LT((transfer.intensive() * field - expected).cwiseAbs().maxCoeff(), 0.016);
}

}  // namespace
}  // namespace pellucida
