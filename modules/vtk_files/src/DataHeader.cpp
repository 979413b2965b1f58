#include "DataHeader.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkType.h>
#include <vtkXMLParser.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

#include "pellucida/core/Error.h"
#include "pellucida/vtk_files/DataFile.h"
#include "pellucida/vtk_files/Silence.h"

namespace pellucida {
namespace {

using Attributes = std::map<std::string, std::string, std::less<>>;

constexpr std::size_t kMostArrays = 64;
constexpr std::size_t kMostNameBytes = 64;
constexpr int kMostComponents = 9;
constexpr std::string_view kAppendedTag = "<AppendedData encoding=\"raw\">";

[[noreturn]] void refuse(const std::string& reason) {
  throw InputError("damaged (" + reason + ")");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::string_view attribute(const Attributes& attributes, const char* name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::string_view() : trimmed(found->second);
}

std::int64_t whole(const Attributes& attributes, const char* name, std::int64_t most, std::int64_t missing) {
  if (!attributes.contains(name)) return missing;
  const std::string_view text = attribute(attributes, name);
  std::int64_t value = -1;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size() || value < 0 || value > most) {
    refuse(std::string(name) + " is \"" + std::string(text.substr(0, 32)) + "\"");
  }
  return value;
}

template <std::size_t kCount>
std::array<double, kCount> numbers(const Attributes& attributes, const char* name) {
  std::array<double, kCount> values{};
  std::string_view text = attribute(attributes, name);
  for (double& value : values) {
    text = trimmed(text);
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || !std::isfinite(value))
      refuse(std::string(name) + " is not " + std::to_string(kCount) + " numbers");
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  if (!trimmed(text).empty()) refuse(std::string(name) + " is not " + std::to_string(kCount) + " numbers");
  return values;
}

struct ValueType {
  const char* name;
  int type;
  int bytes;
};
constexpr ValueType kValueTypes[] = {
    {"Float32", VTK_FLOAT, 4},       {"Float64", VTK_DOUBLE, 8},      {"Int8", VTK_TYPE_INT8, 1},
    {"UInt8", VTK_UNSIGNED_CHAR, 1}, {"Int16", VTK_TYPE_INT16, 2},    {"UInt16", VTK_UNSIGNED_SHORT, 2},
    {"Int32", VTK_INT, 4},           {"UInt32", VTK_UNSIGNED_INT, 4}, {"Int64", VTK_ID_TYPE, 8}};

struct Place {
  const char* element;
  ArrayPlace place;
};
constexpr Place kPlaces[] = {{"FieldData", ArrayPlace::kField},   {"PointData", ArrayPlace::kPointData},
                             {"CellData", ArrayPlace::kCellData}, {"Points", ArrayPlace::kPoints},
                             {"Verts", ArrayPlace::kVerts},       {"Lines", ArrayPlace::kLines},
                             {"Strips", ArrayPlace::kStrips},     {"Polys", ArrayPlace::kPolys}};
constexpr const char* kCellCounts[] = {"NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys"};

// Takes the elements as they come; the library's tree of them is never built.
class HeaderParser : public vtkXMLParser {
 public:
  static HeaderParser* New();
  vtkTypeMacro(HeaderParser, vtkXMLParser);

  DataHeader header;
  std::string fault;

 protected:
  void StartElement(const char* name, const char** pairs) override {
    path_.emplace_back(name);
    if (!fault.empty()) return;
    Attributes attributes;
    for (; pairs && pairs[0]; pairs += 2) attributes.emplace(pairs[0], pairs[1]);
    try {
      take(name, attributes);
    } catch (const InputError& error) {
      fault = error.what();
    }
  }
  void EndElement(const char*) override { path_.pop_back(); }

 private:
  void take(const std::string& name, const Attributes& attributes) {
    const std::string parent = path_.size() > 1 ? path_[path_.size() - 2] : "";
    const auto within = [&](std::initializer_list<const char*> parents) {
      for (const char* one : parents) {
        if (parent == one) return true;
      }
      return false;
    };
    if (name == "VTKFile" && path_.size() == 1) return take_file(attributes);
    if ((name == "PolyData" || name == "ImageData") && path_.size() == 2) return take_data(name, attributes);
    if (name == "AppendedData" && path_.size() == 2) return;
    if (name == "FieldData" && path_.size() == 3 && within({"PolyData", "ImageData"})) return;
    if (name == "Piece" && path_.size() == 3 && within({"PolyData", "ImageData"})) return take_piece(attributes);
    for (const Place& place : kPlaces) {
      if (name == place.element && path_.size() == 4 && parent == "Piece") {
        if (name == "PointData") header.scalars = attribute(attributes, "Scalars");
        return;
      }
      if (name == "DataArray" && parent == place.element && path_.size() <= 5)
        return take_array(place.place, attributes);
    }
    // Ranges that VTK keeps with an array; the numbers themselves decide.
    if (name == "InformationKey" && parent == "DataArray") return;
    if (name == "Value" && parent == "InformationKey") return;
    refuse("an element \"" + name.substr(0, kMostNameBytes) + "\" that no file of a session has");
  }

  void take_file(const Attributes& attributes) {
    const std::string_view type = attribute(attributes, "type");
    if (type != "PolyData" && type != "ImageData") refuse("neither an image nor contours or surfaces");
    header.kind = type == "ImageData" ? DataHeader::Kind::kImage : DataHeader::Kind::kPoly;
    if (attribute(attributes, "byte_order") != "LittleEndian") refuse("its byte order is not little endian");
    const std::string_view sizes = attribute(attributes, "header_type");
    if (sizes != "UInt32" && sizes != "UInt64" && !sizes.empty()) refuse("an unknown type of sizes");
    header.wide = sizes == "UInt64";
    const std::string_view compressor = attribute(attributes, "compressor");
    if (compressor == "vtkZLibDataCompressor") {
      header.compressor = DataHeader::Compressor::kZlib;
    } else if (compressor == "vtkLZ4DataCompressor") {
      header.compressor = DataHeader::Compressor::kLz4;
    } else if (!compressor.empty()) {
      refuse("an unknown compression");
    }
  }

  void take_data(const std::string& name, const Attributes& attributes) {
    const bool image = header.kind == DataHeader::Kind::kImage;
    if (data_seen_ || name != (image ? "ImageData" : "PolyData")) refuse("more than one data set");
    data_seen_ = true;
    if (!image) return;
    whole_extent_ = numbers<6>(attributes, "WholeExtent");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double first = whole_extent_[2 * axis];
      const double last = whole_extent_[2 * axis + 1];
      if (first != 0.0 || last < 0.0 || last >= 1 << 20 || last != std::floor(last)) refuse("an impossible size");
      header.dimensions[axis] = static_cast<int>(last) + 1;
    }
    header.point_count = static_cast<std::int64_t>(header.dimensions[0]) * header.dimensions[1] * header.dimensions[2];
    if (header.point_count > static_cast<std::int64_t>(kMostImageBytes)) refuse("an impossible size");
    header.origin_um = numbers<3>(attributes, "Origin");
    header.spacing_um = numbers<3>(attributes, "Spacing");
    for (const double spacing_um : header.spacing_um) {
      if (!(spacing_um > 0.0)) refuse("an impossible spacing");
    }
  }

  void take_piece(const Attributes& attributes) {
    if (piece_seen_) refuse("more than one piece");
    piece_seen_ = true;
    if (header.kind == DataHeader::Kind::kImage) {
      if (numbers<6>(attributes, "Extent") != whole_extent_) refuse("a piece of another size than the whole");
      return;
    }
    constexpr auto kMost = static_cast<std::int64_t>(kMostPolyBytes);
    header.point_count = whole(attributes, "NumberOfPoints", kMost, 0);
    for (std::size_t i = 0; i < std::size(kCellCounts); ++i) {
      header.cell_count[i] = whole(attributes, kCellCounts[i], kMost, 0);
    }
  }

  void take_array(ArrayPlace place, const Attributes& attributes) {
    ArrayHeader array{.place = place, .name = std::string(attribute(attributes, "Name"))};
    if (header.arrays.size() >= kMostArrays) refuse("more than " + std::to_string(kMostArrays) + " arrays");
    if (array.name.empty() || array.name.size() > kMostNameBytes) refuse("an array without a usable name");
    const std::string_view type = attribute(attributes, "type");
    for (const ValueType& known : kValueTypes) {
      if (type != known.name) continue;
      array.type = known.type;
      array.value_bytes = known.bytes;
    }
    if (array.value_bytes == 0) refuse("array " + array.name + " is of an unknown type");
    if (attribute(attributes, "format") != "appended") refuse("array " + array.name + " is not appended");
    array.components = static_cast<int>(whole(attributes, "NumberOfComponents", kMostComponents, 1));
    if (array.components < 1) refuse("array " + array.name + " has no component");
    array.offset = static_cast<std::uint64_t>(whole(attributes, "offset", std::int64_t{1} << 40U, -1));
    array.tuples = place == ArrayPlace::kField
                       ? whole(attributes, "NumberOfTuples", static_cast<std::int64_t>(kMostHeaderBytes), 0)
                       : -1;
    header.arrays.push_back(std::move(array));
  }

  std::vector<std::string> path_;
  std::array<double, 6> whole_extent_{};
  bool data_seen_ = false;
  bool piece_seen_ = false;
};
vtkStandardNewMacro(HeaderParser);

// Tuples as the file's head implies them; -1 for a list of ids, whose length only its block says.
std::int64_t implied_tuples(const DataHeader& header, const ArrayHeader& array) {
  const auto& cells = header.cell_count;
  switch (array.place) {
    case ArrayPlace::kField:
      return array.tuples;
    case ArrayPlace::kPointData:
    case ArrayPlace::kPoints:
      return header.point_count;
    case ArrayPlace::kCellData: {
      const std::int64_t pixels = static_cast<std::int64_t>(std::max(1, header.dimensions[0] - 1)) *
                                  std::max(1, header.dimensions[1] - 1) * std::max(1, header.dimensions[2] - 1);
      return header.kind == DataHeader::Kind::kImage ? pixels : cells[0] + cells[1] + cells[2] + cells[3];
    }
    default:
      break;
  }
  if (array.name == "connectivity") return -1;
  if (array.name != "offsets") refuse("cells with an unknown array " + array.name);
  return cells[static_cast<std::size_t>(array.place) - static_cast<std::size_t>(ArrayPlace::kVerts)];
}

// Every array's block has the size that its place implies, and all of them together are not too much.
void settle_sizes(DataHeader& header) {
  const std::uint64_t most = header.kind == DataHeader::Kind::kImage ? kMostImageBytes : kMostPolyBytes;
  std::uint64_t total = 0;
  for (ArrayHeader& array : header.arrays) {
    const std::uint64_t bytes = find_block(header, array).bytes;
    const auto tuple_bytes =
        static_cast<std::uint64_t>(array.components) * static_cast<std::uint64_t>(array.value_bytes);
    array.tuples = implied_tuples(header, array);
    if (array.tuples < 0) array.tuples = static_cast<std::int64_t>(bytes / tuple_bytes);
    total += bytes;
    if (total > most) refuse("its data would take more than " + std::to_string(most >> 20U) + " MiB");
    if (static_cast<std::uint64_t>(array.tuples) * tuple_bytes != bytes) {
      refuse("array " + array.name + " has " + std::to_string(bytes) + " bytes where " +
             std::to_string(static_cast<std::uint64_t>(array.tuples) * tuple_bytes) + " belong");
    }
  }
}

std::uint64_t size_at(std::string_view data, std::uint64_t index, bool wide) {
  const std::size_t bytes = wide ? 8 : 4;
  std::uint64_t value = 0;
  std::memcpy(&value, data.data() + index * bytes, bytes);
  return value;
}

}  // namespace

const char* file_type_name(int vtk_type) noexcept {
  // Types of one size that VTK has several names for.
  if (vtk_type == VTK_LONG || vtk_type == VTK_LONG_LONG) return "Int64";
  if (vtk_type == VTK_CHAR || vtk_type == VTK_SIGNED_CHAR) return "Int8";
  for (const ValueType& known : kValueTypes) {
    if (known.type == vtk_type) return known.name;
  }
  return nullptr;
}

DataHeader read_data_header(std::string_view content) {
  // What is appended is not XML: the parser gets the rest.
  const std::size_t tag = content.substr(0, kMostHeaderBytes).find(kAppendedTag);
  if (tag == std::string_view::npos) refuse("no head of a data file");
  std::string head(content.substr(0, tag + kAppendedTag.size()));
  if (head.find("<!") != std::string::npos || head.find('\0') != std::string::npos) {
    refuse("declarations, which no file of a session has");
  }
  head += "</AppendedData></VTKFile>";

  vtkNew<HeaderParser> parser;
  silence(*parser);
  const bool parsed = parser->Parse(head.c_str(), static_cast<unsigned>(head.size())) != 0;
  if (!parser->fault.empty()) throw InputError(parser->fault);
  if (!parsed) refuse("its head is not XML");
  DataHeader header = parser->header;

  std::string_view rest = content.substr(tag + kAppendedTag.size());
  const std::size_t start = rest.find('_');
  if (start == std::string_view::npos || rest.substr(0, start).find_first_not_of(" \n\r\t") != std::string_view::npos) {
    refuse("no data in it");
  }
  const std::size_t end = rest.rfind("</AppendedData>");
  if (end == std::string_view::npos || end <= start) throw InputError("cut off before its end");
  header.appended = rest.substr(start + 1, end - start - 1);
  settle_sizes(header);
  return header;
}

DataBlock find_block(const DataHeader& header, const ArrayHeader& array) {
  const std::uint64_t size_bytes = header.wide ? 8 : 4;
  const std::uint64_t all = header.appended.size();
  const auto cut = [&] { refuse("array " + array.name + " reaches beyond the end of the file"); };
  if (array.offset > all || all - array.offset < size_bytes) cut();
  const std::string_view data = header.appended.substr(array.offset);
  DataBlock block;
  if (header.compressor == DataHeader::Compressor::kNone) {
    block.bytes = size_at(data, 0, header.wide);
    if (block.bytes > data.size() - size_bytes) cut();
    block.part_bytes = block.bytes;
    block.parts.push_back(data.substr(size_bytes, block.bytes));
    return block;
  }
  // Number of parts, decoded size of each, decoded size of the last where it is smaller, compressed sizes.
  if (data.size() < 3 * size_bytes) cut();
  const std::uint64_t count = size_at(data, 0, header.wide);
  block.part_bytes = size_at(data, 1, header.wide);
  const std::uint64_t last_bytes = size_at(data, 2, header.wide);
  if (count > data.size() / size_bytes - 3) cut();
  if (block.part_bytes > kMostPartBytes || last_bytes > block.part_bytes || (count > 0 && block.part_bytes == 0)) {
    refuse("array " + array.name + " is in parts of an impossible size");
  }
  if (count == 0) return block;
  block.bytes = last_bytes == 0 ? count * block.part_bytes : (count - 1) * block.part_bytes + last_bytes;
  std::uint64_t at = (3 + count) * size_bytes;
  block.parts.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t bytes = size_at(data, 3 + i, header.wide);
    if (bytes > data.size() - at) cut();
    block.parts.push_back(data.substr(at, bytes));
    at += bytes;
  }
  return block;
}

}  // namespace pellucida
