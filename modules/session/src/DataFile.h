#pragma once
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <string_view>

#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// The content of a `.vti` file (appended raw; compressed unless the packing is quick). `data` isn't changed.
std::string serialise(vtkImageData* data, Packing packing = Packing::kSmall);
/// The content of a `.vtp` file (appended raw, compressed). `data` isn't changed.
std::string serialise(vtkPolyData* data);

/// The content of a `.vtp` file with no point in it.
std::string empty_poly_file();

/// The data in the content of a `.vti` or `.vtp` file as `serialise` makes them, to the last bit. The content may be
/// anybody's: sizes are held against each other and the file before memory is taken, ids against the points. Throws
/// InputError with the reason alone, without a file's name.
vtkSmartPointer<vtkImageData> image_from(std::string_view content);
vtkSmartPointer<vtkPolyData> poly_from(std::string_view content);

}  // namespace pellucida
