#include "pellucida/teaching_vtk/SnakeImage.h"

#include <vtkFloatArray.h>
#include <vtkImageCast.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <vector>

namespace pellucida {
namespace {

constexpr double kStrongest_share = 1e-3;

double snake_quantile(const Eigen::ArrayXXd& values, double share) {
  std::vector<double> sorted(values.data(), values.data() + values.size());
  const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), place, sorted.end());
  return *place;
}

Eigen::ArrayXXd blurred(const vtkImageData* image, double blur_px) {
  // Not written to: VTK's pipeline takes no const input.
  auto* input = const_cast<vtkImageData*>(image);
  vtkNew<vtkImageCast> cast;
  cast->SetInputData(input);
  cast->SetOutputScalarTypeToFloat();
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputConnection(cast->GetOutputPort());
  smooth->SetDimensionality(2);
  smooth->SetStandardDeviation(blur_px);
  smooth->SetRadiusFactor(4.0);
  smooth->Update();
  vtkImageData* output = smooth->GetOutput();
  const auto* grey = vtkFloatArray::SafeDownCast(output->GetPointData()->GetScalars());
  const int* size = output->GetDimensions();
  using RowMajor = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(const_cast<vtkFloatArray*>(grey)->GetPointer(0), size[1], size[0]).cast<double>();
}

}  // namespace

SnakeField snake_field(const vtkImageData* image, double blur_px, SnakeAttraction attraction) {
  Eigen::ArrayXXd energy = blurred(image, blur_px);
  if (attraction == SnakeAttraction::kEdges) {
    const Eigen::Index rows = energy.rows(), columns = energy.cols();
    Eigen::ArrayXXd squares = Eigen::ArrayXXd::Zero(rows, columns);
    squares.middleCols(1, columns - 2) +=
        (0.5 * (energy.rightCols(columns - 2) - energy.leftCols(columns - 2))).square();
    squares.middleRows(1, rows - 2) += (0.5 * (energy.bottomRows(rows - 2) - energy.topRows(rows - 2))).square();
    energy = -squares;
  } else {
    energy -= snake_quantile(energy, 0.5);
  }
  const double strongest = -snake_quantile(energy, kStrongest_share);
  // A picture without anything in it draws nowhere.
  if (!(strongest > 1e-9)) energy.setZero();
  return SnakeField(strongest > 1e-9 ? Eigen::ArrayXXd(energy / strongest) : energy);
}

}  // namespace pellucida
