#pragma once
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "pellucida/vtk_files/DataWriter.h"

namespace pellucida {

/// Most that a file may hold, decoded: an image of 16 bit has 512 MB at 16,384 x 16,384 pixels, a surface 3 MB.
inline constexpr std::uint64_t kMostImageBytes = std::uint64_t{1} << 30U;
inline constexpr std::uint64_t kMostPolyBytes = std::uint64_t{1} << 28U;

/// The contents as VTK's own writers make them, and as every session was written before there was a `DataWriter`:
/// images zlib 1, or not compressed where the packing is quick; the rest LZ4 1. `data` isn't changed.
std::string serialise(vtkImageData* data, Packing packing = Packing::kSmall);
std::string serialise(vtkPolyData* data);

/// The content of a `.vtp` file with no point in it.
std::string empty_poly_file();

/// The data in the content of a `.vti` or `.vtp` file as `DataWriter` or `serialise` makes them, to the last bit. The
/// content may be anybody's: sizes are held against each other and the file before memory is taken, ids against the
/// points. Throws InputError with the reason alone, without a file's name.
vtkSmartPointer<vtkImageData> image_from(std::string_view content);
vtkSmartPointer<vtkPolyData> poly_from(std::string_view content);

}  // namespace pellucida
