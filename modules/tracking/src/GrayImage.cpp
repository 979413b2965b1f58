#include "GrayImage.h"

#include <cstring>
#include <opencv2/imgproc.hpp>

namespace pellucida {

void load(const ImageView& view, GrayImage& image) {
  image.width = std::max(view.width_px, 8);
  image.height = std::max(view.height_px, 8);
  image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  const auto* base = static_cast<const unsigned char*>(view.data);
  for (int y = 0; y < image.height; ++y) {
    const unsigned char* row = base + static_cast<std::ptrdiff_t>(std::min(y, view.height_px - 1)) * view.row_bytes;
    float* out = image.pixels.data() + static_cast<std::size_t>(y) * image.width;
    if (view.format == PixelFormat::kGray8) {
      for (int x = 0; x < view.width_px; ++x) out[x] = static_cast<float>(row[x]) * (1.0F / 255.0F);
    } else {
      for (int x = 0; x < view.width_px; ++x) {
        std::uint16_t value = 0;
        std::memcpy(&value, row + 2 * static_cast<std::ptrdiff_t>(x), 2);
        out[x] = static_cast<float>(value) * (1.0F / 65535.0F);
      }
    }
    for (int x = view.width_px; x < image.width; ++x) out[x] = out[view.width_px - 1];
  }
}

GrayImage reduced(const GrayImage& image, double sigma_px, int factor) {
  const cv::Mat input(image.height, image.width, CV_32F, const_cast<float*>(image.pixels.data()));
  cv::Mat smooth;  // its own memory: the input stays as it is
  if (sigma_px > 0.0) {
    cv::GaussianBlur(input, smooth, {0, 0}, sigma_px, sigma_px, cv::BORDER_REPLICATE);
  } else {
    smooth = input;
  }
  GrayImage result;
  result.width = std::max(1, (image.width + factor - 1) / factor);
  result.height = std::max(1, (image.height + factor - 1) / factor);
  result.pixels.resize(static_cast<std::size_t>(result.width) * result.height);
  for (int y = 0; y < result.height; ++y) {
    const float* row = smooth.ptr<float>(y * factor);
    float* out = result.pixels.data() + static_cast<std::size_t>(y) * result.width;
    for (int x = 0; x < result.width; ++x) out[x] = row[x * factor];
  }
  return result;
}

double noise_level(const GrayImage& image) {
  // Second differences along rows kill slopes; a sparse grid is enough.
  std::vector<float> values;
  const int step_y = std::max(1, image.height / 64), step_x = std::max(1, image.width / 96);
  for (int y = 1; y < image.height - 1; y += step_y) {
    for (int x = 1; x < image.width - 1; x += step_x) {
      values.push_back(std::abs(image.at(x - 1, y) - 2.0F * image.at(x, y) + image.at(x + 1, y)));
    }
  }
  if (values.empty()) return 0.0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  // Median of |second difference| of white noise: 0.6745 * sqrt(6) * sigma.
  return values[values.size() / 2] / (0.6745 * std::sqrt(6.0));
}

}  // namespace pellucida
