#include "ContainerExtent.h"

#include <array>
#include <cstring>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

namespace pellucida {
namespace {

using Bytes = std::array<unsigned char, 16>;

// 16 bytes at `position` (zeros where the file ends before), and how many of them there are.
std::size_t read_at(std::ifstream& stream, std::uint64_t position, Bytes& bytes) {
  bytes.fill(0);
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(position));
  stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  return static_cast<std::size_t>(stream.gcount());
}

bool has_name(const Bytes& bytes, std::size_t at, std::string_view name) {
  return std::memcmp(bytes.data() + at, name.data(), name.size()) == 0;
}

std::uint64_t big_endian(const Bytes& bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8U | bytes[at + i];
  return value;
}

std::uint64_t little_endian(const Bytes& bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8U | bytes[at + i];
  return value;
}

// Chunks "RIFF" size payload, one after the other (an AVI above 1 GB has several).
void follow_riff(std::ifstream& stream, ContainerExtent& extent) {
  Bytes bytes{};
  std::uint64_t position = 0;
  while (position < extent.file_bytes && read_at(stream, position, bytes) >= 12 && has_name(bytes, 0, "RIFF")) {
    const std::uint64_t size = little_endian(bytes, 4, 4);
    // A writer that couldn't go back leaves 0 or all ones: then nothing is declared.
    if (size == 0 || size == 0xFFFFFFFFU) return;
    position += 8 + size + (size & 1U);
    extent.declared_bytes = position - (size & 1U);
  }
}

// Boxes: size (big endian, 1 = a 64 bit size follows, 0 = to the end), name, payload.
void follow_iso(std::ifstream& stream, ContainerExtent& extent) {
  Bytes bytes{};
  std::uint64_t position = 0;
  extent.has_index = false;
  while (position < extent.file_bytes && read_at(stream, position, bytes) >= 8) {
    if (has_name(bytes, 4, "moov") || has_name(bytes, 4, "moof")) extent.has_index = true;
    std::uint64_t size = big_endian(bytes, 0, 4);
    if (size == 1) size = big_endian(bytes, 8, 8);
    if (size < 8) return;
    // A size that leads round to a place before is longer than any file.
    if (size > std::numeric_limits<std::uint64_t>::max() - position) {
      extent.declared_bytes = std::numeric_limits<std::uint64_t>::max();
      return;
    }
    position += size;
    extent.declared_bytes = position;
  }
}

// An EBML number: the leading zero bits of its first byte give its length. Nothing for the reserved "unknown size".
std::optional<std::uint64_t> ebml_number(const Bytes& bytes, std::size_t& at) {
  std::size_t length = 1;
  while (length <= 8 && (bytes[at] & (0x80U >> (length - 1))) == 0) ++length;
  if (length > 8 || at + length > bytes.size()) return std::nullopt;
  const std::uint64_t mask = (std::uint64_t{1} << (7 * length)) - 1;
  const std::uint64_t value = big_endian(bytes, at, length) & mask;
  at += length;
  return value == mask ? std::nullopt : std::optional(value);
}

// The EBML head, then one segment that holds everything.
void follow_matroska(std::ifstream& stream, ContainerExtent& extent) {
  Bytes bytes{};
  read_at(stream, 0, bytes);
  std::size_t at = 4;
  const auto head_size = ebml_number(bytes, at);
  if (!head_size) return;
  const std::uint64_t segment = at + *head_size;
  if (read_at(stream, segment, bytes) < 5 || !has_name(bytes, 0, "\x18\x53\x80\x67")) return;
  at = 4;
  if (const auto size = ebml_number(bytes, at)) extent.declared_bytes = segment + at + *size;
}

}  // namespace

ContainerExtent container_extent(const std::filesystem::path& file) {
  ContainerExtent extent;
  std::error_code status;
  extent.file_bytes = std::filesystem::file_size(file, status);
  if (status) return {};
  std::ifstream stream(file, std::ios::binary);
  Bytes bytes{};
  if (read_at(stream, 0, bytes) < 12) return extent;
  if (has_name(bytes, 0, "RIFF")) {
    extent.kind = ContainerExtent::Kind::kRiff;
    follow_riff(stream, extent);
  } else if (has_name(bytes, 4, "ftyp")) {
    extent.kind = ContainerExtent::Kind::kIso;
    follow_iso(stream, extent);
  } else if (has_name(bytes, 0, "\x1A\x45\xDF\xA3")) {
    extent.kind = ContainerExtent::Kind::kMatroska;
    follow_matroska(stream, extent);
  }
  return extent;
}

}  // namespace pellucida
