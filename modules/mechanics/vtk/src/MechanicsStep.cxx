#include "pellucida/mechanics_vtk/MechanicsStep.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <string>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/mechanics_vtk/ForceTransfer.h"

namespace pellucida {
namespace {

constexpr const char* kRestDirection = "rest_direction";

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

class MechanicsStep::Impl {
 public:
  explicit Impl(CellProfile profile) : observer_(std::move(profile)) {}

  expected<Scene, StepFailure> process(const Scene& scene) {
    if (!scene.observation) return unexpected<StepFailure>({"mechanics: the scene has no observation"});
    if (scene.run_index != run_index_) {
      run_index_ = scene.run_index;
      observer_.reset();
      said_.clear();
    }
    Scene out = scene;
    const ForceEstimate e = observer_.process(*scene.observation);

    // The row: what is not measured stays empty.
    out.measurement.contact_force_uN = e.contact_force_uN;
    out.measurement.contact_force_lower_uN = e.contact_force_lower_uN;
    out.measurement.contact_force_upper_uN = e.contact_force_upper_uN;
    out.measurement.pressure_Pa = e.converged ? e.pressure_Pa : Measurement::kNotMeasured;
    if (std::isnan(out.measurement.volume_um3)) out.measurement.volume_um3 = e.volume_um3;

    // Why there is no force, said once: a note when the reason is new.
    const bool should_measure =
        scene.observation->state == CellState::kContact || scene.observation->state == CellState::kFree;
    if (should_measure && !e.reason.empty() && e.reason != said_) {
      out.events.push_back({scene.observation->time_s, "note", "no force: " + e.reason});
    }
    if (should_measure) said_ = e.reason;
    if (e.rest_um.cols() == 0 || !e.converged) return out;

    // The model's own surface, and its forces on the surface that people look at.
    out.model = Frozen<vtkPolyData>(make_model(e, scene.observation->time_s, scene.observation->frame_index));
    if (auto surface = scene.surface.shallow_copy()) {
      if (add_forces(e, surface)) out.surface = Frozen<vtkPolyData>(surface);
    }
    return out;
  }

 private:
  bool add_forces(const ForceEstimate& e, vtkPolyData* surface) {
    vtkDataArray* direction = surface->GetPointData()->GetArray(kRestDirection);
    vtkDataArray* membrane = surface->GetPointData()->GetArray(array_name::kMembrane);
    const vtkIdType count = surface->GetNumberOfPoints();
    if (!direction || !membrane || count == 0 || direction->GetNumberOfComponents() != 3) return false;

    // Directions at rest, in the cell frame: there they hardly ever change.
    Eigen::Matrix3Xd directions(3, count);
    for (vtkIdType n = 0; n < count; ++n) direction->GetTuple(n, directions.col(n).data());
    directions = e.rotation_WC.transpose() * directions;
    directions.colwise().normalize();
    const bool known = transfer_ && directions_.cols() == count && nodes_ == e.rest_um.cols() &&
                       (directions_ - directions).cwiseAbs().maxCoeff() < 1e-9;
    if (!known) {
      Eigen::Matrix3Xd model = e.rotation_WC.transpose() * (e.rest_um.colwise() - e.center_um);
      model.colwise().normalize();
      transfer_.emplace(model, e.triangles, directions, outer_areas(surface, membrane, directions));
      directions_ = directions;
      nodes_ = e.rest_um.cols();
    }

    // Forces keep their sum; the tension is read off.
    const Eigen::MatrixXd force = transfer_->extensive() * e.force_uN.transpose();
    const Eigen::VectorXd sigma = transfer_->extensive() * e.force_sigma_uN;
    const Eigen::VectorXd tension = transfer_->intensive() * e.tension_uN_per_um;
    vtkPointData* data = surface->GetPointData();
    data->AddArray(make_array(array_name::kForce, force.transpose()));
    data->AddArray(make_array(array_name::kForceSigma, sigma.transpose()));
    data->AddArray(make_array(array_name::kTension, tension.transpose()));
    return true;
  }

  ForceObserver observer_;
  std::string said_;  // the last reason given
  long run_index_ = 0;
  std::optional<ForceTransfer> transfer_;
  Eigen::Matrix3Xd directions_;  // the surface's, as the transfer was made for
  Eigen::Index nodes_ = 0;       // the model's, likewise
};

MechanicsStep::MechanicsStep(CellProfile profile) : impl_(std::make_unique<Impl>(std::move(profile))) {}
MechanicsStep::~MechanicsStep() = default;
MechanicsStep::MechanicsStep(MechanicsStep&&) noexcept = default;
MechanicsStep& MechanicsStep::operator=(MechanicsStep&&) noexcept = default;

expected<Scene, StepFailure> MechanicsStep::process(const Scene& scene) {
  return impl_->process(scene);
}

}  // namespace pellucida
