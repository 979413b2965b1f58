#include "PartReader.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <new>

#include "Checksum.h"
#include "DiskFile.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/Version.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

// Heads and lists of ids besides the numbers themselves.
constexpr std::uint64_t kMostPartFileBytes = kMostImageBytes + (kMostImageBytes >> 2U);
constexpr double kSpacingTolerance = 1e-9;

[[noreturn]] void refuse_meaning(const std::string& reason) {
  throw InputError("damaged (" + reason + ")");
}

// Stamped as its name says.
void require_stamp(vtkDataObject* data, const DataName& name) {
  vtkFieldData* field = data->GetFieldData();
  for (const char* stamp : {array_name::kTime, array_name::kFrameIndex, array_name::kSchemaVersion}) {
    vtkDataArray* array = field->GetArray(stamp);
    if (!array || array->GetNumberOfTuples() < 1) throw InputError("carries no stamp");
  }
  const double version = field->GetArray(array_name::kSchemaVersion)->GetComponent(0, 0);
  if (version != kSchemaVersion) {
    throw InputError("of schema version " + csv_number(version) + "; this program reads version " +
                     std::to_string(kSchemaVersion));
  }
  if (stamped_frame_index(data) != name.number) {
    const std::string number = std::to_string(stamped_frame_index(data));
    throw InputError(name.kind == kHandKind ? "stamped as block " + number : "stamped as frame " + number);
  }
  if (!std::isfinite(stamped_time_s(data))) throw InputError("stamped with an impossible time");
}

// Whole numbers from 0 to `last`, where the array is there.
void require_kinds(vtkDataArray* array, double last) {
  if (!array) return;
  if (array->GetNumberOfComponents() != 1) refuse_meaning(std::string(array->GetName()) + " has several components");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double value = array->GetComponent(i, 0);
    if (!(value >= 0.0 && value <= last)) {
      refuse_meaning(std::string(array->GetName()) + " is " + csv_number(value) + "; allowed: 0 to " +
                     csv_number(last));
    }
  }
}

void require_components(vtkDataSetAttributes* arrays) {
  struct Vector {
    const char* name;
    int components;
  };
  static constexpr std::array kVectors{
      Vector{array_name::kForce, 3},         Vector{array_name::kForceSigma, 1},  Vector{array_name::kDisplacement, 3},
      Vector{array_name::kTension, 1},       Vector{array_name::kSigma, 1},       Vector{array_name::kConfidence, 1},
      Vector{array_name::kRestDirection, 3}, Vector{array_name::kNeedleForce, 3}, Vector{array_name::kHolderForce, 3},
      Vector{array_name::kAreaStrain, 1},    Vector{array_name::kTensionSigma, 1}};
  for (const Vector& one : kVectors) {
    vtkDataArray* array = arrays->GetArray(one.name);
    if (array && array->GetNumberOfComponents() != one.components) {
      refuse_meaning(std::string(one.name) + " has " + std::to_string(array->GetNumberOfComponents()) + " components");
    }
  }
}

void require_meaning(vtkPolyData* data, int kind) {
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double point_um[3];
    data->GetPoint(i, point_um);
    if (!std::isfinite(point_um[0] + point_um[1] + point_um[2])) {
      refuse_meaning("point " + std::to_string(i) + " is nowhere");
    }
  }
  const bool surface = kind == static_cast<int>(SessionPart::kSurface);
  const bool other_cells = data->GetNumberOfVerts() > 0 || data->GetNumberOfStrips() > 0 ||
                           (surface ? data->GetNumberOfLines() > 0 : data->GetNumberOfPolys() > 0);
  if (other_cells) refuse_meaning(surface ? "not a surface of polygons" : "not lines");
  require_kinds(data->GetPointData()->GetArray(array_name::kMembrane), 2.0);
  require_kinds(data->GetCellData()->GetArray(array_name::kMembrane), 2.0);
  require_kinds(data->GetCellData()->GetArray(array_name::kTool), 1.0);
  require_kinds(data->GetCellData()->GetArray(array_name::kPath), 1.0);
  require_components(data->GetPointData());
}

// An image as the head describes it; zeros there say nothing.
void require_meaning(vtkImageData* image, const SourceInfo& source) {
  const int type = image->GetScalarType();
  if (!image->GetPointData()->GetScalars() || image->GetNumberOfScalarComponents() != 1 ||
      (type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT)) {
    refuse_meaning("not an image of one component of 8 or 16 bit");
  }
  int size_px[3];
  image->GetDimensions(size_px);
  if (size_px[2] != 1) refuse_meaning("an image in layers");
  if (source.width_px > 0 && (size_px[0] != source.width_px || size_px[1] != source.height_px)) {
    refuse_meaning(std::to_string(size_px[0]) + " x " + std::to_string(size_px[1]) + " px where session.json says " +
                   std::to_string(source.width_px) + " x " + std::to_string(source.height_px));
  }
  for (int axis = 0; axis < 2; ++axis) {
    const double spacing_um = image->GetSpacing()[axis];
    const double off_um = std::abs(spacing_um - source.pixel_size_um);
    if (source.pixel_size_um > 0.0 && off_um > kSpacingTolerance * source.pixel_size_um) {
      refuse_meaning("a pixel size of " + csv_number(spacing_um) + " um where session.json says " +
                     csv_number(source.pixel_size_um));
    }
  }
}

}  // namespace

PartReader::PartReader(std::filesystem::path folder, const SessionTable<FileChecksum>& checksums, SourceInfo source)
    : folder_(std::move(folder)), checksums_(checksums), source_(std::move(source)) {}

template <class Data, class Make>
vtkSmartPointer<Data> PartReader::read(const DataName& name, Make make) const {
  const std::filesystem::path file = folder_ / data_file(name);
  const std::string content = read_whole_file(file, kMostPartFileBytes);
  try {
    const FileChecksum* known = find_checksum(checksums_, name);
    const bool same = !known || (known->byte_count == content.size() && known->crc32 == crc32_of(content));
    // What else is wrong with a file says more than its checksum.
    vtkSmartPointer<Data> data = make(content);
    require_stamp(data, name);
    if (!same) throw InputError("damaged (its checksum is not the one in checksums.csv)");
    return data;
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  } catch (const std::bad_alloc&) {
    throw InputError(file.string() + ": needs more memory than there is");
  }
}

vtkSmartPointer<vtkImageData> PartReader::read_image(long frame_index) const {
  return read<vtkImageData>(data_name(SessionPart::kFrame, frame_index), [&](std::string_view content) {
    auto image = image_from(content);
    require_meaning(image, source_);
    return image;
  });
}

vtkSmartPointer<vtkPolyData> PartReader::read_poly(const DataName& name) const {
  return read<vtkPolyData>(name, [&](std::string_view content) {
    auto data = poly_from(content);
    require_meaning(data, name.kind);
    return data;
  });
}

}  // namespace pellucida
