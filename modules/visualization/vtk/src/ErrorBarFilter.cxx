#include "ErrorBarFilter.h"

#include <vtkCellArray.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {

vtkStandardNewMacro(ErrorBarFilter);

int ErrorBarFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  auto* arrows = vtkPolyData::GetData(inputs[0]);
  vtkPointData* data = arrows->GetPointData();
  vtkDataArray* forces = data->GetArray(array_name::kForce);
  vtkDataArray* bars = data->GetArray("bar_um");
  vtkDataArray* kinds = data->GetArray("arrow_kind");
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto stroke = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    lines->InsertNextCell({points->InsertNextPoint(a.data()), points->InsertNextPoint(b.data())});
  };
  for (vtkIdType i = 0; forces && bars && kinds && i < arrows->GetNumberOfPoints(); ++i) {
    double ends_um[2];
    bars->GetTuple(i, ends_um);
    if (!(ends_um[1] > ends_um[0])) continue;
    Eigen::Vector3d node, along;
    arrows->GetPoint(i, node.data());
    forces->GetTuple(i, along.data());
    along.normalize();
    // The end that isn't on the node is the one that moves with the force.
    const Eigen::Vector3d free = kinds->GetComponent(i, 0) == 0.0 ? along : Eigen::Vector3d(-along);
    const Eigen::Vector3d across = this->CrossUm * along.unitOrthogonal(), other = across.cross(along);
    stroke(node + ends_um[0] * free, node + ends_um[1] * free);
    for (const double end_um : ends_um) {
      const Eigen::Vector3d end = node + end_um * free;
      stroke(end - across, end + across);
      stroke(end - other, end + other);
    }
  }
  auto* output = vtkPolyData::GetData(outputs);
  output->SetPoints(points);
  output->SetLines(lines);
  return 1;
}

}  // namespace pellucida
