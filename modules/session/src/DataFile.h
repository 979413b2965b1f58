#pragma once
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// The content of a `.vti` file (appended raw; compressed unless the packing is quick). `data` isn't changed.
std::string serialise(vtkImageData* data, Packing packing = Packing::kSmall);
/// The content of a `.vtp` file (appended raw, compressed). `data` isn't changed.
std::string serialise(vtkPolyData* data);

/// The content of a `.vtp` file with no point in it.
std::string empty_poly_file();

/// Reads a `.vti` or `.vtp` file. Throws InputError, one line, for a file that is missing, cut off or not of that kind.
vtkSmartPointer<vtkImageData> read_image_file(const std::filesystem::path& file);
vtkSmartPointer<vtkPolyData> read_poly_file(const std::filesystem::path& file);

}  // namespace pellucida
