#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

/// Where an array of a data file belongs.
enum class ArrayPlace { kField, kPointData, kCellData, kPoints, kVerts, kLines, kStrips, kPolys };

/// An array as the head of its file describes it.
struct ArrayHeader {
  ArrayPlace place = ArrayPlace::kField;
  std::string name;
  int type = 0;         ///< VTK_FLOAT, ...
  int value_bytes = 0;  ///< of one number
  int components = 1;   ///< 1..9
  std::int64_t tuples = 0;
  std::uint64_t offset = 0;  ///< of its block in the appended data
};

/// The head of a VTK XML file as a session holds it: one piece, all arrays appended raw.
struct DataHeader {
  enum class Kind { kImage, kPoly };
  enum class Compressor { kNone, kZlib, kLz4 };
  Kind kind = Kind::kPoly;
  Compressor compressor = Compressor::kNone;
  bool wide = false;                ///< the sizes in the appended data are UInt64, not UInt32
  std::array<int, 3> dimensions{};  ///< of an image, points
  std::array<double, 3> origin_um{};
  std::array<double, 3> spacing_um{1.0, 1.0, 1.0};
  std::int64_t point_count = 0;
  std::array<std::int64_t, 4> cell_count{};  ///< vertices, lines, strips, polygons
  std::string scalars;                       ///< the point array an image shows; empty for none
  std::vector<ArrayHeader> arrays;
  std::string_view appended;  ///< into the content: blocks of data
};

/// No file of a session needs more: the head of a block of the hand has 10 kB.
inline constexpr std::size_t kMostHeaderBytes = 1U << 16U;
/// A part of a compressed array, decoded.
inline constexpr std::uint64_t kMostPartBytes = 1U << 22U;

/// The name that a data file has for VTK's type of number; null for one that no data file has.
const char* file_type_name(int vtk_type) noexcept;

/// Reads the head and holds every number in it against the others and against the size of the file, so that what it
/// asks for may be allocated. Elements and kinds of data that a session never has are refused; no entity is expanded.
/// Throws InputError with the reason alone, without a file's name.
DataHeader read_data_header(std::string_view content);

/// A block of appended data: its sizes are those of the file, and sound.
struct DataBlock {
  std::uint64_t bytes = 0;              ///< decoded
  std::uint64_t part_bytes = 0;         ///< of all parts but the last, decoded
  std::vector<std::string_view> parts;  ///< compressed, or one that is not
};
/// The block of an array. Throws InputError as above.
DataBlock find_block(const DataHeader& header, const ArrayHeader& array);

}  // namespace pellucida
