#include "DashFilter.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkInformationVector.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pellucida {

vtkStandardNewMacro(DashFilter);

int DashFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  auto* input = vtkPolyData::GetData(inputs[0]);
  auto* output = vtkPolyData::GetData(outputs);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  std::vector<vtkIdType> dash;
  const auto close_dash = [&] {
    if (dash.size() > 1) lines->InsertNextCell(static_cast<vtkIdType>(dash.size()), dash.data());
    dash.clear();
  };

  auto cells = vtk::TakeSmartPointer(input->GetLines()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);

    // Walks along the line; `left_um` is what remains of the present dash or gap.
    bool drawing = true;
    double left_um = this->DashUm;
    for (vtkIdType i = 0; i + 1 < count; ++i) {
      double a[3];
      double b[3];
      input->GetPoint(ids[i], a);
      input->GetPoint(ids[i + 1], b);
      const double length_um = std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
      double done_um = 0.0;
      if (drawing && dash.empty()) dash.push_back(points->InsertNextPoint(a));
      while (length_um - done_um > 1e-9) {
        const double step_um = std::min(left_um, length_um - done_um);
        done_um += step_um;
        left_um -= step_um;
        const double t = done_um / length_um;
        const double p[3] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
        if (drawing) dash.push_back(points->InsertNextPoint(p));
        if (left_um > 1e-9) continue;
        drawing = !drawing;
        left_um = drawing ? this->DashUm : this->GapUm;
        close_dash();
        if (drawing) dash.push_back(points->InsertNextPoint(p));
      }
    }
    close_dash();
  }
  output->SetPoints(points);
  output->SetLines(lines);
  return 1;
}

}  // namespace pellucida
