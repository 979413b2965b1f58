#include "RibbonFilter.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "ColorByte.h"

namespace pellucida {
namespace {

// Points across the ribbon: soft rim, full colour, full colour, soft rim.
constexpr int kAcross = 4;

// A line's points without repeated ones.
std::vector<Eigen::Vector3d> points_of(vtkPolyData* input, vtkIdType count, const vtkIdType* ids) {
  std::vector<Eigen::Vector3d> points;
  for (vtkIdType i = 0; i < count; ++i) {
    Eigen::Vector3d p;
    input->GetPoint(ids[i], p.data());
    if (points.empty() || (p - points.back()).norm() > 1e-9) points.push_back(p);
  }
  return points;
}

// Where the ribbon's edge lies beside a point: across the line, longer at a bend so that the width stays, up to twice.
Eigen::Vector2d side_at(const Eigen::Vector2d& before, const Eigen::Vector2d& after) {
  const Eigen::Vector2d sum = before + after;
  if (sum.norm() < 1e-6) return {-after.y(), after.x()};
  const Eigen::Vector2d along = sum.normalized();
  return Eigen::Vector2d(-along.y(), along.x()) / std::max(along.dot(after), 0.5);
}

}  // namespace

vtkStandardNewMacro(RibbonFilter);

void RibbonFilter::SetColors(std::vector<Color> colors, std::string array) {
  if (colors.empty()) return;
  colors_ = std::move(colors);
  array_ = std::move(array);
  this->Modified();
}

int RibbonFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  auto* input = vtkPolyData::GetData(inputs[0]);
  auto* output = vtkPolyData::GetData(outputs);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> rgba;
  rgba->SetName("color");
  rgba->SetNumberOfComponents(4);
  vtkDataArray* kinds = array_.empty() ? nullptr : input->GetCellData()->GetArray(array_.c_str());
  const double inner_um = std::max(0.5 * (this->WidthUm - this->RimUm), 0.0);
  const double outer_um = 0.5 * (this->WidthUm + this->RimUm);
  const std::array<double, kAcross> offsets_um = {-outer_um, -inner_um, inner_um, outer_um};

  // Cell data count vertices before lines.
  vtkIdType cell = input->GetVerts() ? input->GetVerts()->GetNumberOfCells() : 0;
  auto lines = vtk::TakeSmartPointer(input->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell(), ++cell) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCurrentCell(count, ids);
    const std::vector<Eigen::Vector3d> line = points_of(input, count, ids);
    if (line.size() < 2) continue;
    const std::size_t last = line.size() - 1;
    const bool closed = line.size() > 3 && (line.front() - line.back()).norm() < 1e-9;
    const auto kind = kinds ? static_cast<std::size_t>(std::max(kinds->GetComponent(cell, 0), 0.0)) : 0;
    const Color& color = colors_[std::min(kind, colors_.size() - 1)];

    const auto direction = [&](std::size_t i) -> Eigen::Vector2d {
      return (line[i + 1] - line[i]).head<2>().normalized();
    };
    const vtkIdType first = points->GetNumberOfPoints();
    for (std::size_t i = 0; i <= last; ++i) {
      const Eigen::Vector2d before = i > 0 ? direction(i - 1) : direction(closed ? last - 1 : 0);
      const Eigen::Vector2d after = i < last ? direction(i) : direction(closed ? 0 : last - 1);
      const Eigen::Vector2d side = side_at(before, after);
      for (int k = 0; k < kAcross; ++k) {
        const Eigen::Vector2d p = line[i].head<2>() + offsets_um[static_cast<std::size_t>(k)] * side;
        points->InsertNextPoint(p.x(), p.y(), line[i].z());
        const bool rim = k == 0 || k == kAcross - 1;
        const unsigned char value[4] = {to_byte(color.red), to_byte(color.green), to_byte(color.blue),
                                        rim ? static_cast<unsigned char>(0) : to_byte(this->Opacity)};
        rgba->InsertNextTypedTuple(value);
      }
    }
    for (vtkIdType i = 0; i < static_cast<vtkIdType>(last); ++i) {
      for (vtkIdType k = 0; k + 1 < kAcross; ++k) {
        const vtkIdType at = first + i * kAcross + k;
        quads->InsertNextCell({at, at + 1, at + kAcross + 1, at + kAcross});
      }
    }
  }
  output->SetPoints(points);
  output->SetPolys(quads);
  output->GetPointData()->SetScalars(rgba);
  return 1;
}

}  // namespace pellucida
