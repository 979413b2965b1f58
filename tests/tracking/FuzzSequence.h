#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pellucida/core/ImageView.h"

namespace pellucida::test {

/// Bytes that say what to draw; 0 after the last.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  std::uint8_t byte() { return place_ < size_ ? data_[place_++] : 0; }

  bool empty() const { return place_ >= size_; }

 private:
  const std::uint8_t* data_;
  std::size_t size_, place_ = 0;
};

/// One image of a sequence, in memory of exactly its size, so that a sanitizer sees a byte read too many.
struct FuzzImage {
  std::vector<std::uint8_t> bytes;
  ImageView view;
  bool shows_a_cell = false;  ///< something like a cell was drawn: a tracker may be sure of it
};

/// What an image shows.
enum class FuzzContent { kConstant, kNoise, kGradient, kCheckers, kStripes, kExtremes, kRawBytes, kCell };
inline constexpr int kFuzzContents = 8;

/// An image of `content`; further choices (place of the cell, sizes of squares, levels) come from `choices`.
/// `row_padding_bytes` >= 0: unused bytes after each row but the last.
FuzzImage draw_fuzz_image(int width_px, int height_px, PixelFormat format, int row_padding_bytes, FuzzContent content,
                          ByteReader& choices);

/// Builds a tracker and a sequence of up to 6 images from the bytes (sizes, strides, formats, contents, hints, resets),
/// runs it, and says what was wrong with an observation; "" when nothing was. Errors that the tracker may throw
/// (UsageError) are no fault; a crash or another exception goes through.
std::string run_fuzz_sequence(const std::uint8_t* data, std::size_t size);

}  // namespace pellucida::test
