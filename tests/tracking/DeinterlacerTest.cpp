// Frames of an interlaced camera: a disk that moves by some pixels a frame, every other row older.
#include "Deinterlacer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace pellucida {
namespace {

constexpr int kWidth_px = 160, kHeight_px = 120;
constexpr double kStep_px = 3.0, kNoise_gray = 1.0;

// A bright disk with an edge one pixel wide, after so many steps to the right.
double disk(double x, double y, double steps) {
  const double off = 30.0 - std::hypot(x - 50.0 - kStep_px * steps, y - 60.0);
  return 90.0 + 90.0 / (1.0 + std::exp(-2.0 * off));
}

struct Film {
  explicit Film(int older_rows, double range = 255.0) : older(older_rows), scale(range / 255.0) {}

  template <class Pixel>
  std::vector<Pixel> frame(int index) {
    std::normal_distribution<double> noise(0.0, kNoise_gray);
    std::vector<Pixel> pixels;
    for (int y = 0; y < kHeight_px; ++y)
      for (int x = 0; x < kWidth_px; ++x)
        pixels.push_back(
            static_cast<Pixel>(scale * (disk(x, y, index - (y % 2 == older ? 0.5 : 0.0)) + noise(random))));
    return pixels;
  }

  int older;  // 0 or 1: these rows are half a frame older; 2: none
  double scale;
  std::mt19937 random{3};
};

template <class Pixel>
ImageView view_of(const std::vector<Pixel>& pixels) {
  ImageView view;
  view.data = pixels.data();
  view.format = sizeof(Pixel) == 1 ? PixelFormat::kGray8 : PixelFormat::kGray16;
  view.width_px = kWidth_px;
  view.height_px = kHeight_px;
  view.row_bytes = kWidth_px * static_cast<std::ptrdiff_t>(sizeof(Pixel));
  view.pixel_size_um = 1.0;
  return view;
}

// Root mean square against the scene at the moment of the newer field, grey values of 255.
template <class Pixel>
double error_gray(const ImageView& view, double scale, int index) {
  double sum = 0.0;
  for (int y = 2; y < kHeight_px - 2; ++y)
    for (int x = 2; x < kWidth_px - 2; ++x)
      sum += std::pow(
          static_cast<const Pixel*>(view.data)[y * view.row_bytes / static_cast<int>(sizeof(Pixel)) + x] / scale -
              disk(x, y, index),
          2);
  return std::sqrt(sum / ((kWidth_px - 4) * (kHeight_px - 4)));
}

template <class Pixel>
void expect_whole(int older_rows, double range) {
  Film film(older_rows, range);
  Deinterlacer fields;
  for (int index = 0; index < 12; ++index) {
    const std::vector<Pixel> pixels = film.frame<Pixel>(index);
    const ImageView seen = fields.process(view_of(pixels), kNoise_gray / 255.0);
    if (index < 4) continue;
    ASSERT_TRUE(fields.is_interlaced()) << index;
    EXPECT_GT(error_gray<Pixel>(view_of(pixels), film.scale, index), 3.0);  // as it came
    EXPECT_LT(error_gray<Pixel>(seen, film.scale, index), 2.0) << index;
  }
}

TEST(Deinterlacer, RowsThatMovedAreInterpolatedWhicheverFieldIsOlder) {
  expect_whole<std::uint8_t>(1, 255.0);
  expect_whole<std::uint8_t>(0, 255.0);
}

TEST(Deinterlacer, SixteenBitsAreTheSame) {
  expect_whole<std::uint16_t>(1, 65535.0);
}

TEST(Deinterlacer, FramesTakenAtOnceAreNotTouched) {
  Film film(2);
  Deinterlacer fields;
  for (int index = 0; index < 12; ++index) {
    const std::vector<std::uint8_t> pixels = film.frame<std::uint8_t>(index);
    EXPECT_EQ(fields.process(view_of(pixels), kNoise_gray / 255.0).data, pixels.data());
  }
  EXPECT_FALSE(fields.is_interlaced());
}

TEST(Deinterlacer, NoiseAloneIsNoMotion) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(128.0, 20.0);
  Deinterlacer fields;
  for (int index = 0; index < 50; ++index) {
    std::vector<std::uint8_t> pixels(kWidth_px * kHeight_px);
    for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(std::clamp(noise(random), 0.0, 255.0));
    EXPECT_EQ(fields.process(view_of(pixels), 20.0 / 255.0).data, pixels.data());
  }
}

TEST(Deinterlacer, WhatIsAtRestKeepsItsRows) {
  // A line one pixel thick lies still while the disk moves: interpolation would blur it away.
  Film film(1);
  Deinterlacer fields;
  constexpr int kLine_y = 101;
  for (int index = 0; index < 12; ++index) {
    std::vector<std::uint8_t> pixels = film.frame<std::uint8_t>(index);
    for (int x = 0; x < kWidth_px; ++x) pixels[kLine_y * kWidth_px + x] = 100;  // 10 above the ground
    const ImageView seen = fields.process(view_of(pixels), kNoise_gray / 255.0);
    if (index < 4) continue;
    ASSERT_TRUE(fields.is_interlaced());
    int kept = 0;
    for (int x = 0; x < kWidth_px; ++x)
      kept += static_cast<const std::uint8_t*>(seen.data)[kLine_y * kWidth_px + x] == 100;
    EXPECT_GT(kept, kWidth_px * 95 / 100);
  }
}

TEST(Deinterlacer, AnotherSizeStartsAnew) {
  Film film(1);
  Deinterlacer fields;
  for (int index = 0; index < 8; ++index) fields.process(view_of(film.frame<std::uint8_t>(index)), kNoise_gray / 255.0);
  ASSERT_TRUE(fields.is_interlaced());
  const std::vector<std::uint8_t> pixels = film.frame<std::uint8_t>(8);
  ImageView smaller = view_of(pixels);
  smaller.height_px -= 2;
  EXPECT_EQ(fields.process(smaller, kNoise_gray / 255.0).data, pixels.data());
  EXPECT_FALSE(fields.is_interlaced());
}

}  // namespace
}  // namespace pellucida
