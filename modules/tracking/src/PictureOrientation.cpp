#include "PictureOrientation.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <opencv2/core.hpp>
#include <utility>

namespace pellucida {
namespace {

// Sums of the differences between a pixel's neighbours, weighted by twice its way from the picture's middle.
struct Balance {
  std::int64_t x = 0, y = 0;
};

template <class Pixel>
Balance balance_of(const cv::Mat& image) {
  Balance sum;
  for (int y = 1; y + 1 < image.rows; ++y) {
    const Pixel *above = image.ptr<Pixel>(y - 1), *row = image.ptr<Pixel>(y), *below = image.ptr<Pixel>(y + 1);
    std::int64_t whole = 0;
    for (int x = 1; x + 1 < image.cols; ++x) {
      const int change = std::abs(row[x + 1] - row[x - 1]) + std::abs(below[x] - above[x]);
      whole += change;
      sum.x += std::int64_t{change} * (2 * x - (image.cols - 1));
    }
    sum.y += whole * (2 * y - (image.rows - 1));
  }
  return sum;
}

// The pixels, where they are; copied where rows begin between two pixels, as OpenCV has none of that.
cv::Mat mat_of(const ImageView& view) {
  const int type = view.format == PixelFormat::kGray8 ? CV_8U : CV_16U;
  const auto* bytes = static_cast<const unsigned char*>(view.data);
  const auto row_bytes = static_cast<std::size_t>(view.row_bytes),
             pixel_bytes = static_cast<std::size_t>(CV_ELEM_SIZE(type));
  if (row_bytes % pixel_bytes == 0)
    return {view.height_px, view.width_px, type, const_cast<unsigned char*>(bytes), row_bytes};
  cv::Mat copy(view.height_px, view.width_px, type);
  for (int y = 0; y < view.height_px; ++y)
    std::memcpy(copy.ptr(y), bytes + y * view.row_bytes, pixel_bytes * static_cast<std::size_t>(view.width_px));
  return copy;
}

}  // namespace

void PictureOrientation::choose(const ImageView& view) {
  const cv::Mat image = mat_of(view);
  const Balance sum =
      view.format == PixelFormat::kGray8 ? balance_of<std::uint8_t>(image) : balance_of<std::uint16_t>(image);
  flips_x_ = sum.x > 0;
  flips_y_ = sum.y > 0;
  swaps_ = view.width_px == view.height_px ? std::abs(sum.x) > std::abs(sum.y) : view.height_px > view.width_px;
  is_chosen_ = true;
}

ImageView PictureOrientation::lay(const ImageView& view) {
  last_pixel_um_ = view.pixel_size_um * Eigen::Vector2d(view.width_px - 1, view.height_px - 1);
  if (!flips_x_ && !flips_y_ && !swaps_) return view;
  cv::Mat image = mat_of(view);
  if (flips_x_ || flips_y_) {
    cv::flip(image, flipped_, flips_x_ && flips_y_ ? -1 : flips_x_ ? 1 : 0);
    image = flipped_;
  }
  if (swaps_) {
    cv::transpose(image, laid_);
    image = laid_;
  }
  ImageView result = view;
  result.data = image.data;
  result.width_px = image.cols;
  result.height_px = image.rows;
  result.row_bytes = static_cast<std::ptrdiff_t>(image.step[0]);
  return result;
}

Eigen::Vector2d PictureOrientation::laid_direction(const Eigen::Vector2d& direction) const {
  const Eigen::Vector2d flipped(flips_x_ ? -direction.x() : direction.x(), flips_y_ ? -direction.y() : direction.y());
  return swaps_ ? Eigen::Vector2d(flipped.y(), flipped.x()) : flipped;
}

Eigen::Vector2d PictureOrientation::laid_point(const Eigen::Vector2d& point_um) const {
  const Eigen::Vector2d flipped(flips_x_ ? last_pixel_um_.x() - point_um.x() : point_um.x(),
                                flips_y_ ? last_pixel_um_.y() - point_um.y() : point_um.y());
  return swaps_ ? Eigen::Vector2d(flipped.y(), flipped.x()) : flipped;
}

Contour_um PictureOrientation::laid_points(const Contour_um& points_um) const {
  Contour_um laid = points_um;
  for (Eigen::Index i = 0; i < laid.cols(); ++i) laid.col(i) = laid_point(points_um.col(i));
  return laid;
}

Eigen::Vector2d PictureOrientation::direction_back(const Eigen::Vector2d& direction) const {
  const Eigen::Vector2d d = swaps_ ? Eigen::Vector2d(direction.y(), direction.x()) : direction;
  return {flips_x_ ? -d.x() : d.x(), flips_y_ ? -d.y() : d.y()};
}

Eigen::Vector2d PictureOrientation::point_back(const Eigen::Vector2d& point_um) const {
  const Eigen::Vector2d p = swaps_ ? Eigen::Vector2d(point_um.y(), point_um.x()) : point_um;
  return {flips_x_ ? last_pixel_um_.x() - p.x() : p.x(), flips_y_ ? last_pixel_um_.y() - p.y() : p.y()};
}

void PictureOrientation::take_back(MembraneContour& contour) const {
  const Eigen::Index n = contour.points_um.cols();
  for (Eigen::Index i = 0; i < n; ++i) contour.points_um.col(i) = point_back(contour.points_um.col(i));
  if (!is_mirrored()) return;
  for (Eigen::Index i = 1, k = n - 1; i < k; ++i, --k) {
    contour.points_um.col(i).swap(contour.points_um.col(k));
    if (contour.sigma_um.size() == n) std::swap(contour.sigma_um[i], contour.sigma_um[k]);
    if (contour.confidence.size() == n) std::swap(contour.confidence[i], contour.confidence[k]);
  }
}

void PictureOrientation::take_back(Observation& seen) const {
  if (!flips_x_ && !flips_y_ && !swaps_) return;
  const auto outline_back = [this](Contour_um& points_um) {
    for (Eigen::Index i = 0; i < points_um.cols(); ++i) points_um.col(i) = point_back(points_um.col(i));
  };
  for (std::optional<MembraneContour>* contour : {&seen.outer, &seen.inner, &seen.oolemma})
    if (*contour) take_back(**contour);
  if (seen.needle) {
    seen.needle->tip_um = point_back(seen.needle->tip_um);
    seen.needle->direction = direction_back(seen.needle->direction);
    outline_back(seen.needle->outline_um);
  }
  if (seen.holder) {
    seen.holder->mouth_um = point_back(seen.holder->mouth_um);
    seen.holder->direction = direction_back(seen.holder->direction);
    outline_back(seen.holder->outline_um);
  }
  seen.center_um = point_back(seen.center_um);
  seen.axis = direction_back(seen.axis);
  if (is_mirrored()) seen.rotation_rad = -seen.rotation_rad;
}

}  // namespace pellucida
