#include "pellucida/mechanics_vtk/MechanicsStep.h"
#include "pellucida/mechanics_vtk/NodalForces.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "ForceTransfer.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/membrane/SphereMesh.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

/// Two spheres (outer 52.5, inner 47.5 um) about (100, 80, 0) of rings about the needle's axis, as a reconstruction
/// gives them.
vtkSmartPointer<vtkPolyData> make_surface(const Eigen::Vector3d& axis, int meridian_count, int ring_count) {
  const Eigen::Vector3d side = Eigen::Vector3d::UnitZ().cross(axis);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> membrane;
  membrane->SetName(array_name::kMembrane);
  vtkNew<vtkDoubleArray> direction;
  direction->SetName("rest_direction");
  direction->SetNumberOfComponents(3);
  for (int m = 0; m < 2; ++m) {
    const double radius = m == 0 ? 52.5 : 47.5;
    const vtkIdType first = points->GetNumberOfPoints();
    const auto add = [&](double theta, double phi) {
      const Eigen::Vector3d d =
          std::cos(theta) * axis + std::sin(theta) * (std::cos(phi) * side + std::sin(phi) * Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d p = Eigen::Vector3d(100, 80, 0) + radius * d;
      points->InsertNextPoint(p.data());
      direction->InsertNextTuple(d.data());
      membrane->InsertNextValue(m);
    };
    add(0.0, 0.0);
    for (int r = 1; r <= ring_count; ++r) {
      for (int k = 0; k < meridian_count; ++k) {
        add(std::numbers::pi * r / (ring_count + 1), 2.0 * std::numbers::pi * k / meridian_count);
      }
    }
    add(std::numbers::pi, 0.0);
    const vtkIdType last = points->GetNumberOfPoints() - 1;
    const auto node = [&](int r, int k) { return first + 1 + (r - 1) * meridian_count + k % meridian_count; };
    for (int k = 0; k < meridian_count; ++k) {
      const vtkIdType cap[3] = {first, node(1, k), node(1, k + 1)};
      cells->InsertNextCell(3, cap);
      for (int r = 1; r < ring_count; ++r) {
        const vtkIdType quad[4] = {node(r, k), node(r + 1, k), node(r + 1, k + 1), node(r, k + 1)};
        cells->InsertNextCell(4, quad);
      }
      const vtkIdType tail[3] = {node(ring_count, k), last, node(ring_count, k + 1)};
      cells->InsertNextCell(3, tail);
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->AddArray(membrane);
  surface->GetPointData()->AddArray(direction);
  stamp(surface, 0.5, 15);
  return surface;
}

Scene make_scene(double depth_um, double axis_rad, int meridian_count, int ring_count) {
  Observation o;
  o.time_s = 0.5;
  o.frame_index = 15;
  o.confidence = 1.0;
  o.state = depth_um > 0.0 ? CellState::kContact : CellState::kFree;
  o.center_um = {100.0, 80.0};
  o.rest_outer_radius_um = 52.5;
  o.rest_inner_radius_um = 47.5;
  o.outer.emplace();
  o.axis = {std::cos(axis_rad), std::sin(axis_rad)};
  o.needle = NeedlePose{};
  o.needle->confidence = 1.0;
  o.indentation_um = depth_um;
  o.indentation_sigma_um = 0.1;
  Scene scene;
  scene.observation = std::make_shared<const Observation>(o);
  scene.measurement = measurement_from(o);
  scene.surface =
      Frozen<vtkPolyData>(make_surface({std::cos(axis_rad), std::sin(axis_rad), 0.0}, meridian_count, ring_count));
  return scene;
}

/// Force and surface one after the other, as in the chain.
class MeasuringSteps {
 public:
  explicit MeasuringSteps(CellProfile profile) : mechanics_(std::move(profile)) {}
  expected<Scene, StepFailure> process(const Scene& scene) {
    auto measured = mechanics_.process(scene);
    if (!measured) return unexpected<StepFailure>(std::move(measured.error()));
    return nodal_forces_.add_to(std::move(measured->scene), measured->estimate);
  }

 private:
  MechanicsStep mechanics_;
  NodalForces nodal_forces_;
};

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

class MechanicsStepMesh : public ::testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(MechanicsStepMesh, CarriesTheForcesToTheOuterMembraneWithTheirSum) {
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
TEST_P(MechanicsStepMesh, TheToolsForcesAddUpToTheRowsAndPressurePushesOutwards) {
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
TEST(MechanicsStep, TheStrainIsThatOfTheModelsTriangles) {
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
TEST(MechanicsStep, ACellAtRestBearsNoForceAndNoStrain) {
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
INSTANTIATE_TEST_SUITE_P(Steps, MechanicsStepMesh,
                         ::testing::Values(std::tuple(6, 11), std::tuple(12, 23), std::tuple(36, 47)));

// The force needs no surface, and what is only written has the numbers of what is shown.
TEST(MechanicsStep, TheForceComesBeforeTheSurface) {
  MechanicsStep mechanics(load_profile("mouse-oocyte"));
  NodalForces shown, written;
  for (const double depth_um : {0.0, 8.0, 20.0}) {
    const Scene scene = make_scene(depth_um, 0.3, 36, 47);
    Scene bare = scene;
    bare.surface = {};
    const auto measured = mechanics.process(bare);
    ASSERT_TRUE(measured);
    EXPECT_EQ(measured->scene.measurement.contact_force_uN > 0.0, depth_um > 0.0);
    EXPECT_FALSE(measured->scene.model);
    EXPECT_FALSE(written.forces_on(bare.surface, measured->estimate).force_uN);

    Scene surfaced = measured->scene;
    surfaced.surface = scene.surface;
    const Scene drawn = shown.add_to(surfaced, measured->estimate);
    EXPECT_EQ(to_csv(drawn.measurement), to_csv(measured->scene.measurement));
    EXPECT_TRUE(drawn.model);
    const auto surface = drawn.surface.shallow_copy();
    const SurfaceForces forces = written.forces_on(scene.surface, measured->estimate);
    for (vtkDataArray* array : forces.arrays()) {
      ASSERT_TRUE(array);
      vtkDataArray* expected = surface->GetPointData()->GetArray(array->GetName());
      ASSERT_TRUE(expected) << array->GetName();
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
        for (int k = 0; k < array->GetNumberOfComponents(); ++k) {
          EXPECT_EQ(array->GetComponent(i, k), expected->GetComponent(i, k)) << array->GetName() << ' ' << i;
        }
      }
    }
  }
}

TEST(MechanicsStep, AVolumeMeasuredBeforeIsKept) {
  Scene scene = make_scene(5.0, 0.0, 12, 23);
  scene.measurement.volume_um3 = 123456.0;
  MeasuringSteps step(testing::coarse_profile());
  EXPECT_DOUBLE_EQ(step.process(scene)->measurement.volume_um3, 123456.0);
}

TEST(MechanicsStep, AMissingForceIsExplainedOnce) {
  MeasuringSteps step(testing::coarse_profile());
  Scene scene = make_scene(5.0, 0.0, 12, 23);
  Observation o = *scene.observation;
  o.needle.reset();
  scene.observation = std::make_shared<const Observation>(o);
  const auto first = step.process(scene);
  ASSERT_EQ(first->events.size(), 1u);
  EXPECT_EQ(first->events[0].kind, "note");
  EXPECT_NE(first->events[0].detail.find("needle"), std::string::npos);
  EXPECT_TRUE(std::isnan(first->measurement.contact_force_uN));
  // The event once, the reason beside every frame that lacks its force.
  const auto second = step.process(scene);
  EXPECT_TRUE(second->events.empty());
  EXPECT_NE(second->remarks.reason.find("needle"), std::string::npos);
}

/// A push along x in frame `frame`, with tip and membrane at these depths.
Scene pushed_scene(double tip_um, double membrane_um, CellState state, long frame) {
  Scene scene = make_scene(membrane_um, 0.0, 12, 23);
  Observation o = *scene.observation;
  o.time_s = static_cast<double>(frame) / 30.0;
  o.frame_index = frame;
  o.state = state;
  o.needle->direction = {-1.0, 0.0};
  o.needle->tip_um = o.center_um + Eigen::Vector2d(52.5 - tip_um, 0.0);
  scene.observation = std::make_shared<const Observation>(o);
  scene.measurement = measurement_from(o);
  return scene;
}

TEST(MechanicsStep, APunctureTheMembraneDoesNotBearOutIsNoEvent) {
  MeasuringSteps step(testing::coarse_profile());
  for (long frame = 1; frame <= 12; ++frame) {
    const double depth_um = static_cast<double>(frame);
    step.process(pushed_scene(depth_um, depth_um, CellState::kContact, frame));
  }
  Scene ahead = pushed_scene(21.0, 13.0, CellState::kPunctured, 13);
  ahead.events.push_back({13.0 / 30.0, "puncture", "membrane left at 13.0 um"});
  const auto out = step.process(ahead);
  EXPECT_EQ(out->measurement.state, CellState::kContact);
  EXPECT_EQ(out->contact.state, CellState::kContact);
  EXPECT_GT(out->measurement.contact_force_uN, 0.1);
  ASSERT_EQ(out->events.size(), 1u);
  EXPECT_EQ(out->events[0].kind, "warning");
  EXPECT_NE(out->remarks.warning.find("does not follow"), std::string::npos) << out->remarks.warning;
}

TEST(MechanicsStep, APunctureIsReportedOnceInTheFrameThatShowsIt) {
  MeasuringSteps step(testing::coarse_profile());
  for (long frame = 1; frame <= 20; ++frame) {
    const auto out = step.process(
        pushed_scene(1.0 * static_cast<double>(frame), 1.0 * static_cast<double>(frame), CellState::kContact, frame));
    EXPECT_TRUE(out->events.empty()) << frame;
    EXPECT_EQ(out->measurement.state, CellState::kContact);
    EXPECT_GT(out->measurement.stiffness_uN_per_um, 0.0);
    EXPECT_NEAR(out->measurement.lateral_force_uN, 0.0, 1e-5);
  }
  // Before the tracker says so.
  const auto broken = step.process(pushed_scene(21.0, 10.0, CellState::kContact, 21));
  ASSERT_EQ(broken->events.size(), 1u);
  EXPECT_EQ(broken->events[0].kind, "puncture");
  EXPECT_NE(broken->events[0].detail.find("work"), std::string::npos) << broken->events[0].detail;
  EXPECT_EQ(broken->measurement.state, CellState::kPunctured);
  EXPECT_EQ(broken->measurement.contact_force_uN, 0.0);
  // The tracker's own event, a frame later, would be the same puncture again.
  Scene later = pushed_scene(22.0, 4.0, CellState::kPunctured, 22);
  later.events.push_back({22.0 / 30.0, "puncture", "membrane left at 4.0 um"});
  EXPECT_TRUE(step.process(later)->events.empty());
}

TEST(MechanicsStep, ARevokedPunctureIsAnEvent) {
  MeasuringSteps step(testing::coarse_profile());
  for (long frame = 1; frame <= 20; ++frame) {
    const double depth_um = static_cast<double>(frame);
    step.process(pushed_scene(depth_um, depth_um, CellState::kContact, frame));
  }
  ASSERT_EQ(step.process(pushed_scene(21.0, 5.0, CellState::kContact, 21))->measurement.state, CellState::kPunctured);
  for (long frame = 22; frame <= 23; ++frame)
    EXPECT_EQ(step.process(pushed_scene(21.0, 21.0, CellState::kContact, frame))->measurement.state,
              CellState::kPunctured);
  const auto back = step.process(pushed_scene(21.0, 21.0, CellState::kContact, 24));
  EXPECT_EQ(back->measurement.state, CellState::kContact);
  EXPECT_GT(back->measurement.contact_force_uN, 0.1);
  ASSERT_FALSE(back->events.empty());
  EXPECT_EQ(back->events[0].kind, event_kind::kRevoked) << back->events[0].detail;
}

TEST(MechanicsStep, ScenesWithoutCellOrSurfacePassOn) {
  MeasuringSteps step(testing::coarse_profile());
  Scene no_surface = make_scene(5.0, 0.0, 12, 23);
  no_surface.surface = {};
  const auto a = step.process(no_surface);
  ASSERT_TRUE(a.has_value());
  EXPECT_FALSE(a->surface);
  EXPECT_TRUE(a->model);
  EXPECT_GT(a->measurement.contact_force_uN, 0.0);

  Scene no_cell;
  no_cell.observation = std::make_shared<const Observation>();
  const auto b = step.process(no_cell);
  ASSERT_TRUE(b.has_value());
  EXPECT_FALSE(b->model);
  EXPECT_TRUE(std::isnan(b->measurement.contact_force_uN));

  EXPECT_FALSE(step.process(Scene{}).has_value());
}

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
