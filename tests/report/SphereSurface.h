#pragma once
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>

namespace pellucida::test {

/// Two spheres about one centre, outer and inner, of quads and triangles: grown from `rest_um` (the inner one: 0.9 of
/// it, and by 5 times the growth) to `growth` times it, with the arrays `membrane` and `displacement_um`.
inline vtkSmartPointer<vtkPolyData> sphere_surface(double rest_um, double growth) {
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> membrane;
  vtkNew<vtkDoubleArray> displacement;
  membrane->SetName("membrane");
  displacement->SetName("displacement_um");
  displacement->SetNumberOfComponents(3);
  constexpr int kRings = 12, kMeridians = 24;
  for (int m = 0; m < 2; ++m) {
    const double radius_um = m == 0 ? rest_um : 0.9 * rest_um;
    const double more_um = radius_um * (growth - 1.0) * (m == 0 ? 1.0 : 5.0);
    const vtkIdType first = points->GetNumberOfPoints();
    for (int r = 0; r <= kRings; ++r) {
      for (int k = 0; k < kMeridians; ++k) {
        const double polar = M_PI * r / kRings, turn = 2.0 * M_PI * k / kMeridians;
        const double direction[3] = {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                                     std::cos(polar)};
        points->InsertNextPoint(100.0 + (radius_um + more_um) * direction[0],
                                80.0 + (radius_um + more_um) * direction[1], (radius_um + more_um) * direction[2]);
        displacement->InsertNextTuple3(more_um * direction[0], more_um * direction[1], more_um * direction[2]);
        membrane->InsertNextValue(m);
      }
    }
    for (int r = 0; r < kRings; ++r) {
      for (int k = 0; k < kMeridians; ++k) {
        const int next = (k + 1) % kMeridians;
        const vtkIdType corners[4] = {first + r * kMeridians + k, first + (r + 1) * kMeridians + k,
                                      first + (r + 1) * kMeridians + next, first + r * kMeridians + next};
        cells->InsertNextCell(4, corners);
      }
    }
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->AddArray(membrane);
  surface->GetPointData()->AddArray(displacement);
  return surface;
}

/// The same tension on all nodes of the outer membrane, and another on all of the inner one.
inline void add_tension(vtkPolyData* surface, double outer_uN_per_um, double inner_uN_per_um) {
  vtkNew<vtkDoubleArray> tension;
  tension->SetName("tension_uN_per_um");
  vtkDataArray* membrane = surface->GetPointData()->GetArray("membrane");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    tension->InsertNextValue(membrane->GetTuple1(i) == 0.0 ? outer_uN_per_um : inner_uN_per_um);
  }
  surface->GetPointData()->AddArray(tension);
}

}  // namespace pellucida::test
