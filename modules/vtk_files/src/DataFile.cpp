#include "pellucida/vtk_files/DataFile.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "DataHeader.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core_vtk/OwnArrays.h"
#include "pellucida/vtk_files/Silence.h"

namespace pellucida {
namespace {

// How a kind of data was packed.
struct Compression {
  int compressor;
  int level;
};
constexpr Compression kImageCompression{vtkXMLWriter::ZLIB, 1};
constexpr Compression kNoCompression{vtkXMLWriter::NONE, 0};
constexpr Compression kPolyCompression{vtkXMLWriter::LZ4, 1};

// Raw appended blocks are the smallest and fastest form VTK reads everywhere. Other threads may write the same arrays,
// and VTK's writers write into them.
template <class Writer, class Data>
std::string serialise_with(Data* data, Compression compression) {
  vtkNew<Data> copy;
  copy->ShallowCopy(data);
  give_own_arrays(copy);
  vtkNew<Writer> writer;
  writer->SetInputData(copy);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorType(compression.compressor);
  if (compression.level > 0) writer->SetCompressionLevel(compression.level);
  writer->SetWriteToOutputString(true);
  if (writer->Write() != 1) throw Error(ExitCode::kOurFault, "a data object could not be turned into a VTK file");
  return writer->GetOutputString();
}

// Whole files end so; one that was cut off does not.
void require_end(std::string_view content) {
  const std::string_view tail = content.substr(content.size() - std::min<std::size_t>(content.size(), 32));
  if (tail.find("</VTKFile>") == std::string_view::npos) throw InputError("cut off before its end");
}

vtkSmartPointer<vtkDataCompressor> make_decompressor(DataHeader::Compressor kind) {
  if (kind == DataHeader::Compressor::kZlib) return vtkSmartPointer<vtkZLibDataCompressor>::New();
  if (kind == DataHeader::Compressor::kLz4) return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  return nullptr;
}

// Decodes the arrays of one file.
class ArrayReader {
 public:
  explicit ArrayReader(const DataHeader& header)
      : header_(header), decompressor_(make_decompressor(header.compressor)) {
    if (decompressor_) silence(*decompressor_);
  }

  vtkSmartPointer<vtkDataArray> read(const ArrayHeader& array) const {
    const DataBlock block = find_block(header_, array);
    auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array.type));
    values->SetName(array.name.c_str());
    values->SetNumberOfComponents(array.components);
    values->SetNumberOfTuples(array.tuples);
    auto* target = static_cast<unsigned char*>(values->GetVoidPointer(0));
    std::uint64_t at = 0;
    for (const std::string_view part : block.parts) {
      const std::uint64_t bytes = std::min(block.part_bytes, block.bytes - at);
      if (!decompressor_) {
        std::memcpy(target + at, part.data(), bytes);
      } else if (decompressor_->Uncompress(reinterpret_cast<const unsigned char*>(part.data()), part.size(),
                                           target + at, bytes) != bytes) {
        throw InputError("damaged (array " + array.name + " can't be decompressed)");
      }
      at += bytes;
    }
    return values;
  }

 private:
  const DataHeader& header_;
  vtkSmartPointer<vtkDataCompressor> decompressor_;
};

// The lines or faces of one kind, their ids all below `point_count`.
vtkSmartPointer<vtkCellArray> make_cells(vtkDataArray* ends, vtkDataArray* ids, vtkIdType point_count) {
  if (!ends || !ids || ends->GetNumberOfComponents() != 1 || ids->GetNumberOfComponents() != 1) {
    throw InputError("damaged (cells without their points)");
  }
  const vtkIdType cell_count = ends->GetNumberOfTuples();
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->SetNumberOfTuples(cell_count + 1);
  offsets->SetValue(0, 0);
  double before = 0.0;
  for (vtkIdType i = 0; i < cell_count; ++i) {
    const double end = ends->GetComponent(i, 0);
    if (!(end >= before && end <= static_cast<double>(ids->GetNumberOfTuples()))) {
      throw InputError("damaged (a cell's points are not in its list)");
    }
    offsets->SetValue(i + 1, static_cast<vtkIdType>(end));
    before = end;
  }
  if (before != static_cast<double>(ids->GetNumberOfTuples())) {
    throw InputError("damaged (a list of points is longer than its cells)");
  }
  connectivity->SetNumberOfTuples(ids->GetNumberOfTuples());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i) {
    const double id = ids->GetComponent(i, 0);
    if (!(id >= 0.0 && id < static_cast<double>(point_count))) {
      throw InputError("damaged (a cell names point " + csv_number(id) + " of " + std::to_string(point_count) + ")");
    }
    connectivity->SetValue(i, static_cast<vtkIdType>(id));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

}  // namespace

std::string serialise(vtkImageData* data, Packing packing) {
  return serialise_with<vtkXMLImageDataWriter>(data, packing == Packing::kQuick ? kNoCompression : kImageCompression);
}

std::string serialise(vtkPolyData* data) {
  return serialise_with<vtkXMLPolyDataWriter>(data, kPolyCompression);
}

std::string empty_poly_file() {
  // ParaView warns of a file without a list of points, though it be empty.
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtkNew<vtkPoints>());
  return DataWriter().write(data.Get());
}

vtkSmartPointer<vtkImageData> image_from(std::string_view content) {
  require_end(content);
  const DataHeader header = read_data_header(content);
  if (header.kind != DataHeader::Kind::kImage) throw InputError("damaged (no image)");
  const ArrayReader reader(header);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(header.dimensions.data());
  image->SetOrigin(header.origin_um.data());
  image->SetSpacing(header.spacing_um.data());
  for (const ArrayHeader& array : header.arrays) {
    if (array.place == ArrayPlace::kField) image->GetFieldData()->AddArray(reader.read(array));
    if (array.place == ArrayPlace::kPointData) image->GetPointData()->AddArray(reader.read(array));
    if (array.place == ArrayPlace::kCellData) image->GetCellData()->AddArray(reader.read(array));
  }
  if (!header.scalars.empty()) image->GetPointData()->SetActiveScalars(header.scalars.c_str());
  return image;
}

vtkSmartPointer<vtkPolyData> poly_from(std::string_view content) {
  require_end(content);
  const DataHeader header = read_data_header(content);
  if (header.kind != DataHeader::Kind::kPoly) throw InputError("damaged (neither contours nor a surface)");
  const ArrayReader reader(header);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  std::map<std::pair<ArrayPlace, std::string>, vtkSmartPointer<vtkDataArray>> topology;
  for (const ArrayHeader& array : header.arrays) {
    const auto values = reader.read(array);
    switch (array.place) {
      case ArrayPlace::kField:
        data->GetFieldData()->AddArray(values);
        break;
      case ArrayPlace::kPointData:
        data->GetPointData()->AddArray(values);
        break;
      case ArrayPlace::kCellData:
        data->GetCellData()->AddArray(values);
        break;
      default:
        topology[{array.place, array.name}] = values;
        break;
    }
  }
  const vtkSmartPointer<vtkDataArray> coordinates = topology[{ArrayPlace::kPoints, "Points"}];
  if (coordinates ? coordinates->GetNumberOfComponents() != 3 : header.point_count > 0) {
    throw InputError("damaged (points without their places)");
  }
  if (coordinates) {
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    data->SetPoints(points);
  }
  const auto cells = [&](ArrayPlace place) -> vtkSmartPointer<vtkCellArray> {
    if (header.cell_count[static_cast<std::size_t>(place) - static_cast<std::size_t>(ArrayPlace::kVerts)] == 0)
      return nullptr;
    return make_cells(topology[{place, "offsets"}], topology[{place, "connectivity"}], header.point_count);
  };
  data->SetVerts(cells(ArrayPlace::kVerts));
  data->SetLines(cells(ArrayPlace::kLines));
  data->SetStrips(cells(ArrayPlace::kStrips));
  data->SetPolys(cells(ArrayPlace::kPolys));
  return data;
}

}  // namespace pellucida
