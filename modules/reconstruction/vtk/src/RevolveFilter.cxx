#include "pellucida/reconstruction_vtk/RevolveFilter.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>
#include <numbers>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

// A closed polyline's points; its repeated first point is left out.
Contour_um contour_of(vtkPolyData* data, vtkIdType cell) {
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(cell, ids);
  const vtkIdType count = ids->GetNumberOfIds();
  const bool closed = count > 1 && ids->GetId(0) == ids->GetId(count - 1);
  Contour_um contour_um(2, closed ? count - 1 : count);
  for (Eigen::Index i = 0; i < contour_um.cols(); ++i) {
    double point[3];
    data->GetPoint(ids->GetId(i), point);
    contour_um.col(i) << point[0], point[1];
  }
  return contour_um;
}

// Radius of the circle with the contour's area.
double equivalent_radius_um(const Contour_um& contour_um) {
  double twice_area = 0.0;
  const Eigen::Index n = contour_um.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto a = contour_um.col(i);
    const auto b = contour_um.col((i + 1) % n);
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  return std::sqrt(std::abs(0.5 * twice_area) / std::numbers::pi);
}

// Collects the surfaces of all membranes into one output.
class SurfaceBuilder {
 public:
  SurfaceBuilder() {
    membrane_->SetName(array_name::kMembrane);
    displacement_um_->SetName(array_name::kDisplacement);
    displacement_um_->SetNumberOfComponents(3);
    rest_direction_->SetName(array_name::kRestDirection);
    rest_direction_->SetNumberOfComponents(3);
    volume_um3_->SetName("volume_um3");
  }

  void append(const RevolvedMesh& revolved, int membrane, const Eigen::Vector3d& center_um, double rest_radius_um,
              double step_deg) {
    const vtkIdType first = points_->GetNumberOfPoints();
    for (Eigen::Index i = 0; i < revolved.mesh.nodes_um.cols(); ++i) {
      const Eigen::Vector3d node_um = revolved.mesh.nodes_um.col(i);
      const Eigen::Vector3d direction = revolved.rest_direction.col(i);
      const Eigen::Vector3d displacement_um = node_um - center_um - rest_radius_um * direction;
      points_->InsertNextPoint(node_um.data());
      membrane_->InsertNextValue(membrane);
      displacement_um_->InsertNextTuple(displacement_um.data());
      rest_direction_->InsertNextTuple(direction.data());
    }
    for (const auto& cell : revolved.mesh.cells) {
      const int corners = ClosedMesh::is_triangle(cell) ? 3 : 4;
      polygons_->InsertNextCell(corners);
      for (int i = 0; i < corners; ++i) polygons_->InsertCellPoint(first + cell[static_cast<std::size_t>(i)]);
    }
    // A ring of n nodes encloses (n / 2 pi) sin(2 pi / n) of its circle: undone here, so the volume does not depend on
    // n.
    const double step_rad = step_deg * std::numbers::pi / 180.0;
    volume_um3_->InsertNextValue(volume_um3(revolved.mesh) * step_rad / std::sin(step_rad));
  }

  void finish(vtkPolyData* output) const {
    output->SetPoints(points_);
    output->SetPolys(polygons_);
    output->GetPointData()->AddArray(membrane_);
    output->GetPointData()->AddArray(displacement_um_);
    output->GetPointData()->AddArray(rest_direction_);
    output->GetFieldData()->AddArray(volume_um3_);
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polygons_;
  vtkNew<vtkIntArray> membrane_;
  vtkNew<vtkFloatArray> displacement_um_;
  vtkNew<vtkFloatArray> rest_direction_;
  vtkNew<vtkDoubleArray> volume_um3_;
};

}  // namespace

vtkStandardNewMacro(RevolveFilter);

void RevolveFilter::SetOptions(const RevolveOptions& options) {
  validate(options);
  options_ = options;
  this->Modified();
}

int RevolveFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  auto* input = vtkPolyData::GetData(inputs[0]);
  auto* output = vtkPolyData::GetData(outputs);
  failure_.clear();
  output->GetFieldData()->PassData(input->GetFieldData());
  if (input->GetNumberOfCells() == 0) return 1;

  const auto fail = [&](const std::string& reason) {
    failure_ = reason;
    this->SetErrorCode(1);
    output->Initialize();
    return 0;
  };
  auto* membranes = input->GetCellData()->GetArray(array_name::kMembrane);
  auto* centers = input->GetFieldData()->GetArray(array_name::kCenter);
  auto* axes = input->GetFieldData()->GetArray(array_name::kAxis);
  auto* radii_um = input->GetFieldData()->GetArray(array_name::kRestRadius);
  if (!membranes || !centers || !axes || !radii_um) {
    return fail("the contours lack one of the arrays membrane, center_um, axis, rest_radius_um");
  }
  const Eigen::Vector2d center_um(centers->GetComponent(0, 0), centers->GetComponent(0, 1));
  const Eigen::Vector2d axis(axes->GetComponent(0, 0), axes->GetComponent(0, 1));

  SurfaceBuilder builder;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell) {
    const int membrane = static_cast<int>(membranes->GetComponent(cell, 0));
    if (membrane > static_cast<int>(Membrane::kInner)) continue;
    const Contour_um contour_um = contour_of(input, cell);
    const auto revolved = revolve(contour_um, center_um, axis, options_);
    if (!revolved) return fail(revolved.error());
    const double known_um = radii_um->GetComponent(0, membrane);
    const double rest_radius_um = known_um > 0.0 ? known_um : equivalent_radius_um(contour_um);
    builder.append(*revolved, membrane, {center_um.x(), center_um.y(), 0.0}, rest_radius_um, options_.step_deg);
  }
  builder.finish(output);
  return 1;
}

}  // namespace pellucida
