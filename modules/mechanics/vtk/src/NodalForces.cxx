#include "pellucida/mechanics_vtk/NodalForces.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <optional>

#include "ForceTransfer.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

constexpr const char* kRestDirection = "rest_direction";
/// The surface brings its directions with 32 bits: nearer than this they are the same.
constexpr double kSameDirection = 1e-6;

/// A point array of `values` (components x points).
vtkSmartPointer<vtkDoubleArray> make_array(const char* name, const Eigen::Ref<const Eigen::MatrixXd>& values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.rows()));
  array->SetNumberOfTuples(values.cols());
  Eigen::Map<Eigen::MatrixXd>(array->GetPointer(0), values.rows(), values.cols()) = values;
  return array;
}

/// The model in its solved shape.
vtkSmartPointer<vtkPolyData> make_model(const ForceEstimate& e, double time_s, long frame_index) {
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetData(make_array("points", e.solved_um));
  vtkNew<vtkCellArray> cells;
  cells->AllocateEstimate(e.triangles.cols(), 3);
  for (Eigen::Index t = 0; t < e.triangles.cols(); ++t) {
    const vtkIdType nodes[3] = {e.triangles(0, t), e.triangles(1, t), e.triangles(2, t)};
    cells->InsertNextCell(3, nodes);
  }
  auto model = vtkSmartPointer<vtkPolyData>::New();
  model->SetPoints(points);
  model->SetPolys(cells);
  model->GetPointData()->AddArray(make_array(array_name::kForce, e.force_uN));
  model->GetPointData()->AddArray(make_array(array_name::kDisplacement, e.solved_um - e.rest_um));
  model->GetPointData()->AddArray(make_array(array_name::kTension, e.tension_uN_per_um.transpose()));
  model->GetPointData()->AddArray(make_array(array_name::kAreaStrain, e.area_strain_percent.transpose()));
  model->GetFieldData()->AddArray(make_array(array_name::kCenter, e.center_um));
  model->GetFieldData()->AddArray(make_array(array_name::kAxis, e.rotation_WC.col(2)));
  stamp(model, time_s, frame_index);
  return model;
}

/// Share of the unit sphere of each node of the outer membrane, from the surface's cells at rest; 0 on other membranes.
Eigen::VectorXd outer_areas(vtkPolyData* surface, vtkDataArray* membrane, const Eigen::Matrix3Xd& directions) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(directions.cols());
  const auto is_outer = [&](vtkIdType node) {
    return static_cast<int>(membrane->GetTuple1(node)) == static_cast<int>(Membrane::kOuter);
  };
  vtkCellArray* cells = surface->GetPolys();
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
    vtkIdType count = 0;
    const vtkIdType* nodes = nullptr;
    cells->GetCellAtId(c, count, nodes);
    if (count < 3 || !is_outer(nodes[0])) continue;
    double area = 0.0;
    for (vtkIdType k = 1; k + 1 < count; ++k) {
      const Eigen::Vector3d a = directions.col(nodes[0]);
      area += 0.5 * (directions.col(nodes[k]) - a).cross(directions.col(nodes[k + 1]) - a).norm();
    }
    for (vtkIdType k = 0; k < count; ++k) areas[nodes[k]] += area / static_cast<double>(count);
  }
  return areas;
}

}  // namespace

class NodalForces::Impl {
 public:
  SurfaceForces forces_on(const ForceEstimate& e, vtkPolyData* surface) {
    vtkDataArray* direction = surface->GetPointData()->GetArray(kRestDirection);
    vtkDataArray* membrane = surface->GetPointData()->GetArray(array_name::kMembrane);
    const vtkIdType count = surface->GetNumberOfPoints();
    if (!direction || !membrane || count == 0 || direction->GetNumberOfComponents() != 3) return {};

    // Directions at rest, in the cell frame: there they hardly ever change.
    Eigen::Matrix3Xd directions(3, count);
    for (vtkIdType n = 0; n < count; ++n) direction->GetTuple(n, directions.col(n).data());
    directions = e.rotation_WC.transpose() * directions;
    directions.colwise().normalize();
    const bool known = transfer_ && directions_.cols() == count && nodes_ == e.rest_um.cols() &&
                       (directions_ - directions).cwiseAbs().maxCoeff() < kSameDirection;
    if (!known) {
      Eigen::Matrix3Xd model = e.rotation_WC.transpose() * (e.rest_um.colwise() - e.center_um);
      model.colwise().normalize();
      transfer_.emplace(model, e.triangles, directions, outer_areas(surface, membrane, directions));
      directions_ = directions;
      nodes_ = e.rest_um.cols();
    }

    // Forces keep their sum; tension and strain are read off.
    const auto handed = [&](const char* name, const Eigen::MatrixXd& of_nodes) {
      return make_array(name, (transfer_->extensive() * of_nodes.transpose()).transpose());
    };
    const auto read_off = [&](const char* name, const Eigen::VectorXd& of_nodes) {
      return make_array(name, (transfer_->intensive() * of_nodes).transpose());
    };
    return {.force_uN = handed(array_name::kForce, e.force_uN),
            .force_sigma_uN = handed(array_name::kForceSigma, e.force_sigma_uN.transpose()),
            .needle_force_uN = handed(array_name::kNeedleForce, e.needle_force_uN),
            .holder_force_uN = handed(array_name::kHolderForce, e.holder_force_uN),
            .tension_uN_per_um = read_off(array_name::kTension, e.tension_uN_per_um),
            .tension_sigma_uN_per_um = read_off(array_name::kTensionSigma, e.tension_sigma_uN_per_um),
            .area_strain_percent = read_off(array_name::kAreaStrain, e.area_strain_percent)};
  }

 private:
  std::optional<ForceTransfer> transfer_;
  Eigen::Matrix3Xd directions_;  // the surface's, as the transfer was made for
  Eigen::Index nodes_ = 0;       // the model's, likewise
};

NodalForces::NodalForces() : impl_(std::make_unique<Impl>()) {}
NodalForces::~NodalForces() = default;
NodalForces::NodalForces(NodalForces&&) noexcept = default;
NodalForces& NodalForces::operator=(NodalForces&&) noexcept = default;

SurfaceForces NodalForces::forces_on(const Frozen<vtkPolyData>& surface, const ForceEstimate& estimate) {
  if (!surface || estimate.rest_um.cols() == 0 || !estimate.converged) return {};
  // Only read; VTK's getters are not const.
  return impl_->forces_on(estimate, const_cast<vtkPolyData*>(surface.get()));
}

Scene NodalForces::add_to(Scene scene, const ForceEstimate& e) {
  if (e.rest_um.cols() == 0 || !e.converged) return scene;
  scene.model = Frozen<vtkPolyData>(make_model(e, e.time_s, e.frame_index));
  const SurfaceForces forces = forces_on(scene.surface, e);
  if (!forces.force_uN) return scene;
  auto surface = scene.surface.shallow_copy();
  for (vtkDataArray* array : forces.arrays()) surface->GetPointData()->AddArray(array);
  scene.surface = Frozen<vtkPolyData>(surface);
  return scene;
}

}  // namespace pellucida
