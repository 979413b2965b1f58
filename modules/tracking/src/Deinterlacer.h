#pragma once
#include <cstdint>
#include <vector>

#include "pellucida/core/ImageView.h"

namespace pellucida {

/// Frames of an interlaced camera, made whole: every other row of such a frame is older, and an edge that moved in
/// between is a comb that no filter along its normal can place. Rows that moved are interpolated between those of the
/// newer field; rows at rest stay as they are. A source counts as interlaced where, in what moves, the rows of one
/// field are nearer to the frame before than those of the other; frames taken at once show no such difference, whatever
/// their noise, and pass through untouched.
class Deinterlacer {
 public:
  /// The frame to evaluate: `view` itself, or an image of the same size and format that lives until the next call.
  /// `noise` is the standard deviation of a pixel, 0..1 of the format's range.
  ImageView process(const ImageView& view, double noise);

  bool is_interlaced() const noexcept { return interlaced_; }
  /// The next frame has no predecessor.
  void reset();

 private:
  bool has_before(const ImageView& view) const noexcept;
  template <class Pixel>
  const Pixel* row(const std::vector<std::uint8_t>& image, int y) const;
  template <class Pixel>
  void look_at(double noise);
  template <class Pixel>
  void compare_fields(int threshold);
  template <class Pixel>
  void interpolate_moved(int threshold);

  std::vector<std::uint8_t> before_, now_, whole_;  // the last two frames as they came, the result; rows without gaps
  int width_px_ = 0, height_px_ = 0;
  PixelFormat format_ = PixelFormat::kGray8;
  // Of late, where sampled rows moved: pixels, and how far rows 1, 3, 5 ... and 0, 2, 4 ... are from the other field
  // one frame earlier, sums of grey values.
  double moved_ = 0.0, odd_off_ = 0.0, even_off_ = 0.0;
  int turn_ = 0;  // which rows are sampled
  bool interlaced_ = false, odd_is_older_ = false;
};

}  // namespace pellucida
