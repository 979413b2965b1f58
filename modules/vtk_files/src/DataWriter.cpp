#include "pellucida/vtk_files/DataWriter.h"

#include <libdeflate.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "DataHeader.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// Levels of libdeflate, by measurement (README): higher ones cost several times as much for 2 to 6 %.
constexpr int kImageLevel = 1;
constexpr int kPolyLevel = 1;
// What comes again in file after file is worth the effort of packing it once more.
constexpr int kRepeatedLevel = 12;
// Smaller arrays aren't worth keeping.
constexpr std::size_t kLeastKept_bytes = 1024;

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const noexcept { libdeflate_free_compressor(compressor); }
};
using Compressor = std::unique_ptr<libdeflate_compressor, FreeCompressor>;

Compressor make_compressor(int level) {
  Compressor compressor(libdeflate_alloc_compressor(level));
  if (!compressor) throw Error(ExitCode::kOurFault, "no memory to compress a data file with");
  return compressor;
}

// A number as VTK's reader takes it back to the same one.
std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

void put_size(std::string& text, std::uint64_t size) {
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ExitCode::kOurFault, "an array of " + std::to_string(size) + " bytes is too large for a data file");
  }
  const auto word = static_cast<std::uint32_t>(size);
  text.append(reinterpret_cast<const char*>(&word), sizeof word);
}

std::string_view bytes_of(vtkDataArray* array) {
  return {static_cast<const char*>(array->GetVoidPointer(0)),
          static_cast<std::size_t>(array->GetNumberOfValues()) * static_cast<std::size_t>(array->GetDataTypeSize())};
}

std::string_view bytes_of(const std::vector<std::int32_t>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(std::int32_t)};
}

std::vector<std::int32_t> narrow_indices(vtkDataArray* array, vtkIdType first) {
  std::vector<std::int32_t> values(static_cast<std::size_t>(array->GetNumberOfTuples() - first));
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<std::int32_t>(array->GetComponent(first + static_cast<vtkIdType>(i), 0));
  }
  return values;
}

}  // namespace

class DataWriter::Impl {
 public:
  std::string write(vtkImageData* data, Packing packing) {
    begin(packing == Packing::kQuick ? nullptr : &image_);
    int extent[6];
    data->GetExtent(extent);
    std::string whole;
    for (const int end : extent) whole += (whole.empty() ? "" : " ") + std::to_string(end);
    const double* origin = data->GetOrigin();
    const double* spacing = data->GetSpacing();
    const auto three = [](const double* v) {
      return number_text(v[0]) + ' ' + number_text(v[1]) + ' ' + number_text(v[2]);
    };
    start_file("ImageData");
    xml_ += "<ImageData WholeExtent=\"" + whole + "\" Origin=\"" + three(origin) + "\" Spacing=\"" + three(spacing) +
            "\" Direction=\"1 0 0 0 1 0 0 0 1\">\n";
    add_field(data->GetFieldData());
    xml_ += "<Piece Extent=\"" + whole + "\">\n";
    vtkDataArray* scalars = data->GetPointData()->GetScalars();
    const std::string shown =
        scalars && scalars->GetName() ? " Scalars=\"" + escaped(scalars->GetName()) + '"' : std::string();
    add_arrays("PointData", shown, data->GetPointData());
    add_arrays("CellData", "", data->GetCellData());
    xml_ += "</Piece>\n</ImageData>\n";
    return finish();
  }

  std::string write(vtkPolyData* data, const PackedArrays* common) {
    begin(&poly_);
    common_ = common;
    start_file("PolyData");
    xml_ += "<PolyData>\n";
    add_field(data->GetFieldData());
    xml_ += "<Piece NumberOfPoints=\"" + std::to_string(data->GetNumberOfPoints()) + '"';
    const auto cells = {std::pair("Verts", data->GetVerts()), std::pair("Lines", data->GetLines()),
                        std::pair("Strips", data->GetStrips()), std::pair("Polys", data->GetPolys())};
    for (const auto& kind : cells) {
      xml_ += std::string(" NumberOf") + kind.first + "=\"" + std::to_string(kind.second->GetNumberOfCells()) + '"';
    }
    xml_ += ">\n";
    add_arrays("PointData", "", data->GetPointData());
    add_arrays("CellData", "", data->GetCellData());
    xml_ += "<Points>\n";
    // VTK warns of a file without a list of points, though it be empty.
    vtkNew<vtkPoints> none;
    vtkPoints* points = data->GetPoints() ? data->GetPoints() : none.Get();
    add_array("Points", points->GetData(), "Points");
    xml_ += "</Points>\n";
    for (const auto& kind : cells) {
      if (kind.second->GetNumberOfCells() > 0) add_cells(kind.first, kind.second);
    }
    xml_ += "</Piece>\n</PolyData>\n";
    return finish();
  }

  /// `put(object, part, packed)` for each array of `data`, and twice for its cells.
  template <class Put>
  void pack(vtkPolyData* data, Put put) {
    begin(&poly_);
    const auto take = [&](vtkObjectBase* object, int part) { put(object, part, std::exchange(appended_, {})); };
    vtkPointData* arrays = data->GetPointData();
    std::vector<std::pair<std::string_view, std::string>> before;
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
      vtkDataArray* array = arrays->GetArray(i);
      if (!array || !array->GetName()) continue;
      // What was recorded is often what is there again.
      const std::string_view numbers = bytes_of(array);
      const auto same =
          std::find_if(before.begin(), before.end(), [&](const auto& one) { return one.first == numbers; });
      if (same != before.end()) {
        appended_ = same->second;
      } else {
        append(numbers, std::string("PointData/") + array->GetName());
        before.emplace_back(numbers, appended_);
      }
      take(array, kWhole);
    }
    if (vtkPoints* points = data->GetPoints()) {
      append(bytes_of(points->GetData()), "Points/Points");
      take(points->GetData(), kWhole);
    }
    for (const auto& [place, cells] : {std::pair("Lines", data->GetLines()), std::pair("Polys", data->GetPolys())}) {
      if (cells->GetNumberOfCells() == 0) continue;
      append(bytes_of(narrow_indices(cells->GetConnectivityArray(), 0)), std::string(place) + "/connectivity");
      take(cells, kConnectivity);
      append(bytes_of(narrow_indices(cells->GetOffsetsArray(), 1)), std::string(place) + "/offsets");
      take(cells, kOffsets);
    }
  }

 private:
  // Parts of an object in `PackedArrays`.
  static constexpr int kWhole = 0, kConnectivity = 0, kOffsets = 1;

  // What an array was packed to, to be used again for the same numbers.
  struct Kept {
    std::string numbers;
    std::string packed;
    bool repeated = false;
  };

  void begin(Compressor* compressor) {
    compressor_ = compressor ? compressor->get() : nullptr;
    common_ = nullptr;
    xml_.clear();
    appended_.clear();
  }

  void start_file(const char* type) {
    xml_ += std::string("<VTKFile type=\"") + type +
            "\" version=\"0.1\" byte_order=\"LittleEndian\" header_type=\"UInt32\"" +
            (compressor_ ? " compressor=\"vtkZLibDataCompressor\">\n" : ">\n");
  }

  std::string finish() {
    std::string content = std::move(xml_);
    content.reserve(content.size() + appended_.size() + 128);
    content += "<AppendedData encoding=\"raw\">\n_";
    content += appended_;
    content += "\n</AppendedData>\n</VTKFile>\n";
    return content;
  }

  void add_field(vtkFieldData* field) {
    if (field->GetNumberOfArrays() == 0) return;
    xml_ += "<FieldData>\n";
    for (int i = 0; i < field->GetNumberOfArrays(); ++i) {
      vtkDataArray* array = field->GetArray(i);
      if (!array || !array->GetName()) continue;
      add_array(array->GetName(), array, "", " NumberOfTuples=\"" + std::to_string(array->GetNumberOfTuples()) + '"');
    }
    xml_ += "</FieldData>\n";
  }

  void add_arrays(const char* place, const std::string& attributes, vtkDataSetAttributes* arrays) {
    xml_ += std::string("<") + place + attributes + ">\n";
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
      vtkDataArray* array = arrays->GetArray(i);
      if (array && array->GetName()) add_array(array->GetName(), array, place);
    }
    xml_ += std::string("</") + place + ">\n";
  }

  void add_cells(const char* place, vtkCellArray* cells) {
    xml_ += std::string("<") + place + ">\n";
    add_element("connectivity", "Int32", "");
    if (!append_common(cells, kConnectivity)) {
      append(bytes_of(narrow_indices(cells->GetConnectivityArray(), 0)), std::string(place) + "/connectivity");
    }
    add_element("offsets", "Int32", "");
    if (!append_common(cells, kOffsets)) {
      append(bytes_of(narrow_indices(cells->GetOffsetsArray(), 1)), std::string(place) + "/offsets");
    }
    xml_ += std::string("</") + place + ">\n";
  }

  // `place`: of an array that may come again; empty for one too small for that.
  void add_array(const char* name, vtkDataArray* array, const std::string& place, const std::string& more = {}) {
    std::string attributes = more;
    const int components = array->GetNumberOfComponents();
    if (components > 1) attributes += " NumberOfComponents=\"" + std::to_string(components) + '"';
    for (int i = 0; i < components && array->HasAComponentName(); ++i) {
      if (const char* component = array->GetComponentName(i)) {
        attributes += " ComponentName" + std::to_string(i) + "=\"" + escaped(component) + '"';
      }
    }
    const char* type = file_type_name(array->GetDataType());
    if (!type) {
      throw Error(ExitCode::kOurFault, std::string("array ") + name + " is of a type that no data file has");
    }
    add_element(name, type, attributes);
    if (append_common(array, kWhole)) return;
    append(bytes_of(array), place.empty() ? std::string() : place + '/' + name);
  }

  void add_element(const char* name, const char* type, const std::string& attributes) {
    xml_ += std::string("<DataArray type=\"") + type + "\" Name=\"" + escaped(name) + '"' + attributes +
            " format=\"appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
  }

  // What is packed already, where it is.
  bool append_common(const vtkObjectBase* object, int part) {
    const std::string* packed = common_ ? common_->find(object, part) : nullptr;
    if (packed) appended_ += *packed;
    return packed != nullptr;
  }

  void append(std::string_view numbers, const std::string& name) {
    if (!compressor_) {
      put_size(appended_, numbers.size());
      appended_ += numbers;
      return;
    }
    if (compressor_ != poly_.get() || name.empty() || numbers.size() < kLeastKept_bytes) {
      pack(numbers, compressor_, appended_);
      return;
    }
    Kept& kept = kept_[name];
    if (kept.numbers != numbers) {
      kept.numbers = numbers;
      kept.packed.clear();
      kept.repeated = false;
      pack(numbers, compressor_, kept.packed);
    } else if (!kept.repeated) {
      kept.packed.clear();
      kept.repeated = true;
      pack(numbers, repeated_.get(), kept.packed);
    }
    appended_ += kept.packed;
  }

  // A compressed block: number of parts, size of a part, size of the last where it is smaller, packed sizes, parts.
  void pack(std::string_view numbers, libdeflate_compressor* compressor, std::string& target) {
    const std::uint64_t part = std::min<std::uint64_t>(numbers.size(), kMostPartBytes);
    const std::uint64_t count = numbers.empty() ? 0 : (numbers.size() + part - 1) / part;
    put_size(target, count);
    put_size(target, part);
    put_size(target, count == 0 ? 0 : numbers.size() - (count - 1) * part == part ? 0 : numbers.size() % part);
    const std::size_t sizes_at = target.size();
    target.resize(target.size() + count * sizeof(std::uint32_t));
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string_view one = numbers.substr(i * part, part);
      const std::size_t at = target.size();
      target.resize(at + libdeflate_zlib_compress_bound(compressor, one.size()));
      const auto bytes = static_cast<std::uint32_t>(
          libdeflate_zlib_compress(compressor, one.data(), one.size(), target.data() + at, target.size() - at));
      target.resize(at + bytes);
      std::memcpy(target.data() + sizes_at + i * sizeof bytes, &bytes, sizeof bytes);
    }
  }

  Compressor image_ = make_compressor(kImageLevel);
  Compressor poly_ = make_compressor(kPolyLevel);
  Compressor repeated_ = make_compressor(kRepeatedLevel);
  libdeflate_compressor* compressor_ = nullptr;
  const PackedArrays* common_ = nullptr;
  std::map<std::string, Kept> kept_;
  std::string xml_;
  std::string appended_;
};

DataWriter::DataWriter() : impl_(std::make_unique<Impl>()) {}
DataWriter::~DataWriter() = default;

std::string DataWriter::write(vtkImageData* data, Packing packing) {
  return impl_->write(data, packing);
}
std::string DataWriter::write(vtkPolyData* data, const PackedArrays* common) {
  return impl_->write(data, common);
}
PackedArrays DataWriter::pack(vtkPolyData* data) {
  PackedArrays packed;
  impl_->pack(data, [&](vtkObjectBase* object, int part, std::string content) {
    packed.kept_.emplace_back(object);
    packed.packed_[{object, part}] = std::move(content);
  });
  return packed;
}

const std::string* PackedArrays::find(const vtkObjectBase* object, int part) const {
  const auto found = packed_.find({object, part});
  return found == packed_.end() ? nullptr : &found->second;
}

}  // namespace pellucida
