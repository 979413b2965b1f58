#include "Deinterlacer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace pellucida {
namespace {

// What noise does not make of a difference between two frames: this many standard deviations of a pixel (a difference
// has 1.4 of them), and at least so much of the format's range.
constexpr double kDifference_sigma = 5.0, kLeastDifference = 0.016;
// One row of so many is looked at each frame, in turn.
constexpr int kSampled = 8;
// The sampled pixels that moved that a verdict needs, and what a frame leaves of those counted before.
constexpr double kEnoughMoved = 300.0, kKept = 0.9;
// By how much the rows of one field are nearer to the frame before than those of the other, of the sum of both, for an
// interlaced source, and for one that was so far. Frames taken at once: 0 in the mean (0.2 where a needle's tip has
// begun to move, and little else); fields half a frame apart: 0.5.
constexpr double kBecomesInterlaced = 0.3, kStaysInterlaced = 0.2;

// Between a row above and one below, along the direction in which they agree best (edge-based line averaging).
template <class Pixel>
Pixel between(const Pixel* above, const Pixel* below, int x, int width) {
  int best = std::numeric_limits<int>::max();
  int value = above[x];
  for (const int lean : {0, -1, 1, -2, 2}) {
    if (x + lean < 0 || x + lean >= width || x - lean < 0 || x - lean >= width) continue;
    const int a = above[x + lean], b = below[x - lean];
    // A lean that is no better than the upright is none.
    if (std::abs(a - b) < best) {
      best = std::abs(a - b);
      value = (a + b + 1) / 2;
    }
  }
  return static_cast<Pixel>(value);
}

}  // namespace

void Deinterlacer::reset() {
  *this = {};
}

bool Deinterlacer::has_before(const ImageView& view) const noexcept {
  return view.width_px == width_px_ && view.height_px == height_px_ && view.format == format_;
}

template <class Pixel>
const Pixel* Deinterlacer::row(const std::vector<std::uint8_t>& image, int y) const {
  return reinterpret_cast<const Pixel*>(image.data()) + static_cast<std::ptrdiff_t>(y) * width_px_;
}

// Where something moved, rows of each field are compared with those of the other field one frame earlier: the older
// field of a frame is the nearer one.
template <class Pixel>
void Deinterlacer::compare_fields(int threshold) {
  moved_ *= kKept;
  even_off_ *= kKept;
  odd_off_ *= kKept;
  turn_ = (turn_ + 1) % (kSampled / 2);
  for (int y = 1 + 2 * turn_; y + 2 < height_px_; y += kSampled) {
    const Pixel *odd = row<Pixel>(now_, y), *even = row<Pixel>(now_, y + 1);
    const Pixel *a = row<Pixel>(before_, y - 1), *b = row<Pixel>(before_, y), *c = row<Pixel>(before_, y + 1),
                *d = row<Pixel>(before_, y + 2);
    std::int64_t moved = 0, odd_off = 0, even_off = 0;
    for (int x = 0; x < width_px_; ++x) {
      if (std::abs(odd[x] - b[x]) <= threshold && std::abs(even[x] - c[x]) <= threshold) continue;
      ++moved;
      odd_off += std::abs(2 * odd[x] - a[x] - c[x]);
      even_off += std::abs(2 * even[x] - b[x] - d[x]);
    }
    moved_ += static_cast<double>(moved);
    odd_off_ += static_cast<double>(odd_off);
    even_off_ += static_cast<double>(even_off);
  }
  if (moved_ < kEnoughMoved) return;
  const double nearer = (even_off_ - odd_off_) / std::max(1.0, even_off_ + odd_off_);
  interlaced_ = std::abs(nearer) > (interlaced_ ? kStaysInterlaced : kBecomesInterlaced);
  odd_is_older_ = nearer > 0.0;
}

template <class Pixel>
void Deinterlacer::interpolate_moved(int threshold) {
  std::copy(now_.begin(), now_.end(), whole_.begin());
  for (int y = odd_is_older_ ? 1 : 2; y + 1 < height_px_; y += 2) {
    const Pixel *above = row<Pixel>(now_, y - 1), *here = row<Pixel>(now_, y), *below = row<Pixel>(now_, y + 1);
    const Pixel* earlier = row<Pixel>(before_, y);
    auto* out = const_cast<Pixel*>(row<Pixel>(whole_, y));
    for (int x = 0; x < width_px_; ++x) {
      const bool rests = std::abs(here[x] - earlier[x]) < threshold &&
                         std::abs(above[x] - earlier[x - width_px_]) < threshold &&
                         std::abs(below[x] - earlier[x + width_px_]) < threshold;
      if (!rests) out[x] = between(above, below, x, width_px_);
    }
  }
}

template <class Pixel>
void Deinterlacer::look_at(double noise) {
  constexpr double range = std::numeric_limits<Pixel>::max();
  const int threshold = static_cast<int>(std::lround(range * std::max(kLeastDifference, kDifference_sigma * noise)));
  compare_fields<Pixel>(threshold);
  if (interlaced_) interpolate_moved<Pixel>(threshold);
}

ImageView Deinterlacer::process(const ImageView& view, double noise) {
  const std::size_t row_bytes =
      (view.format == PixelFormat::kGray8 ? 1U : 2U) * static_cast<std::size_t>(view.width_px);
  const bool is_first = !has_before(view);
  if (is_first) {
    reset();
    width_px_ = view.width_px;
    height_px_ = view.height_px;
    format_ = view.format;
    for (auto* image : {&before_, &now_, &whole_}) image->resize(row_bytes * static_cast<std::size_t>(view.height_px));
  }
  std::swap(before_, now_);
  for (int y = 0; y < view.height_px; ++y)
    std::memcpy(now_.data() + static_cast<std::size_t>(y) * row_bytes,
                static_cast<const unsigned char*>(view.data) + y * view.row_bytes, row_bytes);
  if (is_first) return view;
  view.format == PixelFormat::kGray8 ? look_at<std::uint8_t>(noise) : look_at<std::uint16_t>(noise);
  if (!interlaced_) return view;
  ImageView result = view;
  result.data = whole_.data();
  result.row_bytes = static_cast<std::ptrdiff_t>(row_bytes);
  return result;
}

}  // namespace pellucida
