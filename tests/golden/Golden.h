#pragma once
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

namespace pellucida::test {

/// How two pictures differ, place by place: the picture is divided into squares of `kTile_px`.
struct GoldenDifference {
  static constexpr int kTile_px = 32;
  /// The most that a square may differ by, in pixels from black to white. Renderers differ by the softness of edges,
  /// by far less; an element that is missing by more (GoldenTest shows both).
  static constexpr double kMost = 9.0;

  double worst_tile = 0.0;
  int worst_x_px = 0;  ///< of that square's middle, from the upper left corner
  int worst_y_px = 0;

  bool is_small() const noexcept { return worst_tile <= kMost; }
  std::string text() const;
};

/// VTK's own comparison (vtkImageDifference): of each pixel with those about it, so that a shift by one is none, and
/// without what is below 20 of 255. Pictures of different sizes differ wholly.
GoldenDifference difference_of(vtkImageData* one, vtkImageData* other);

/// The picture `name` of tests/golden/images; null where there is none.
vtkSmartPointer<vtkImageData> golden_picture(const std::string& name);

/// Whether PELLUCIDA_WRITE_GOLDEN is set: pictures are to be written, not compared.
bool writes_golden();

/// Writes it, in 128 colours where pngquant is installed.
void write_golden(vtkImageData* picture, const std::string& name);

}  // namespace pellucida::test
