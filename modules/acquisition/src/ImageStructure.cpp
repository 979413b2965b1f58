#include "ImageStructure.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr std::array<std::uint32_t, 256> kCrcTable = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value & 1U) != 0 ? 0xEDB88320U ^ (value >> 1U) : value >> 1U;
    table[i] = value;
  }
  return table;
}();

std::uint32_t crc(std::string_view bytes) {
  std::uint32_t value = 0xFFFFFFFFU;
  for (const char c : bytes) value = kCrcTable[(value ^ static_cast<unsigned char>(c)) & 0xFFU] ^ (value >> 8U);
  return ~value;
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

std::uint32_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

// Beyond this a head is garbled: no camera has a gigapixel.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 30U;

/// Says what is wrong with one file.
class Judge {
 public:
  explicit Judge(const std::filesystem::path& file) : file_(file.string()) {}
  [[noreturn]] void cut_off() const {
    throw InputError(file_ + ": broken image (cut off before its end); copy it again");
  }
  [[noreturn]] void damaged(const char* what) const {
    throw InputError(file_ + ": broken image (" + what + "); copy it again");
  }

  [[noreturn]] void refused(const char* what) const { throw InputError(file_ + ": " + what); }

 private:
  std::string file_;
};

bool is_png_head(std::string_view head) {
  if (head.size() != 13) return false;
  constexpr std::uint64_t kLargest = 1000000;
  const std::uint64_t width = big_endian(head, 0, 4);
  const std::uint64_t height = big_endian(head, 4, 4);
  const int depth = head[8];
  const int colour = head[9];
  const bool deep = depth == 8 || depth == 16;
  const bool shallow = depth == 1 || depth == 2 || depth == 4;
  const bool kind = colour == 0   ? deep || shallow
                    : colour == 3 ? depth == 8 || shallow
                                  : (colour == 2 || colour == 4 || colour == 6) && deep;
  return width > 0 && height > 0 && width <= kLargest && height <= kLargest && width * height <= kMostPixels && kind &&
         head[10] == 0 && head[11] == 0 && (head[12] == 0 || head[12] == 1);
}

// Chunks: length, name, payload, checksum. All must be whole, the necessary ones there, in order.
ImageStructure check_png(std::string_view bytes, const Judge& judge) {
  ImageStructure structure;
  bool has_palette = false;
  bool has_pixels = false;
  char colour = 0;
  std::size_t at = 8;
  for (bool first = true;; first = false) {
    if (bytes.size() < at + 12) judge.cut_off();
    const std::size_t length = big_endian(bytes, at, 4);
    if (length > bytes.size() - at - 12) judge.cut_off();
    const std::string_view name = bytes.substr(at + 4, 4);
    const std::string_view payload = bytes.substr(at + 8, length);
    if (crc(bytes.substr(at + 4, length + 4)) != big_endian(bytes, at + 8 + length, 4))
      judge.damaged("a checksum is wrong");
    if (first != (name == "IHDR") || (first && !is_png_head(payload))) judge.damaged("its header is invalid");
    if (first) {
      colour = payload[9];
      structure.width_px = static_cast<int>(big_endian(payload, 0, 4));
      structure.height_px = static_cast<int>(big_endian(payload, 4, 4));
    }
    if (name == "IEND") break;
    if (name == "PLTE") {
      if (has_palette || has_pixels || length == 0 || length > 768 || length % 3 != 0)
        judge.damaged("its palette is invalid");
      has_palette = true;
    } else if (name == "IDAT") {
      if (colour == 3 && !has_palette) judge.damaged("its palette is missing");
      has_pixels = true;
    } else if (name == "pHYs" && length == 9 && payload[8] == 1 &&
               big_endian(payload, 0, 4) == big_endian(payload, 4, 4)) {
      // Pixels a metre.
      structure.pixel_size_um = plausible_pixel_size_um(1e6 / big_endian(payload, 0, 4));
    } else if (name[0] >= 'A' && name[0] <= 'Z' && !first) {
      judge.damaged("it has a part that no decoder knows");
    }
    at += length + 12;
  }
  if (!has_pixels) judge.damaged("it has no pixels");
  return structure;
}

// Segments: FF, marker, length. The picture's data follow the scan's head; within them FF is followed by 00 or a
// restart marker only, so that the end marker after them can't be part of them.
ImageStructure check_jpeg(std::string_view bytes, const Judge& judge) {
  std::size_t at = 2;
  ImageStructure structure;
  while (true) {
    while (at + 1 < bytes.size() && bytes[at] == '\xFF' && bytes[at + 1] == '\xFF') ++at;
    if (bytes.size() < at + 4) judge.cut_off();
    if (bytes[at] != '\xFF') judge.damaged("its header is invalid");
    const auto marker = static_cast<unsigned char>(bytes[at + 1]);
    const std::size_t length = big_endian(bytes, at + 2, 2);
    if (length < 2) judge.damaged("its header is invalid");
    if (length > bytes.size() - at - 2) judge.cut_off();
    // Start of frame, but for the tables that share its range: depth, height, width.
    if (marker >= 0xC0U && marker <= 0xCFU && marker != 0xC4U && marker != 0xC8U && marker != 0xCCU) {
      if (length < 8 || bytes[at + 4] != 8) judge.damaged("its header is invalid, or it is not of 8 bit");
      structure.height_px = static_cast<int>(big_endian(bytes, at + 5, 2));
      structure.width_px = static_cast<int>(big_endian(bytes, at + 7, 2));
    }
    at += length + 2;
    if (marker == 0xDAU) break;
  }
  if (structure.width_px == 0 || structure.height_px == 0) judge.damaged("it has no size");
  if (bytes.find("\xFF\xD9", at) == std::string_view::npos) judge.cut_off();
  return structure;
}

// A head with the size, then rows padded to four bytes.
ImageStructure check_bmp(std::string_view bytes, const Judge& judge) {
  if (bytes.size() < 54) judge.cut_off();
  const std::uint64_t start = little_endian(bytes, 10, 4);
  const std::uint64_t width = little_endian(bytes, 18, 4);
  const auto height = static_cast<std::uint64_t>(std::llabs(static_cast<std::int32_t>(little_endian(bytes, 22, 4))));
  const std::uint64_t depth = little_endian(bytes, 28, 2);
  if (width == 0 || width > 100000 || height == 0 || height > 100000 || width * height > kMostPixels)
    judge.damaged("its header is invalid");
  // Plain pixels, or plain ones with masks of their colours.
  const std::uint64_t compression = little_endian(bytes, 30, 4);
  if (compression != 0 && compression != 3)
    judge.refused("a BMP with run lengths or another compression; convert it to PNG");
  if (bytes.size() < start + (width * depth + 31) / 32 * 4 * height) judge.cut_off();
  return {.pixel_size_um = {}, .width_px = static_cast<int>(width), .height_px = static_cast<int>(height)};
}

}  // namespace

ImageStructure check_structure(const std::filesystem::path& file, ImageKind kind, double most_megapixels) {
  if (kind == ImageKind::kTiff || kind == ImageKind::kNone) return {};
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const Judge judge(file);
  const ImageStructure structure = kind == ImageKind::kPng    ? check_png(bytes, judge)
                                   : kind == ImageKind::kJpeg ? check_jpeg(bytes, judge)
                                                              : check_bmp(bytes, judge);
  require_size(file.string(), static_cast<std::uint64_t>(structure.width_px),
               static_cast<std::uint64_t>(structure.height_px), most_megapixels);
  return structure;
}

}  // namespace pellucida
