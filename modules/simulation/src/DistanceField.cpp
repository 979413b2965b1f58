#include "DistanceField.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace pellucida {
namespace {

// Beyond the band only inside or outside counts.
void fill_far(const Contour_um& contour_px, float band_um, cv::Mat1f& distance_um) {
  constexpr int kShift = 6;
  std::vector<cv::Point> polygon(static_cast<std::size_t>(contour_px.cols()));
  for (Eigen::Index i = 0; i < contour_px.cols(); ++i)
    polygon[static_cast<std::size_t>(i)] = {static_cast<int>(std::lround(contour_px(0, i) * (1 << kShift))),
                                            static_cast<int>(std::lround(contour_px(1, i) * (1 << kShift)))};
  distance_um.setTo(band_um);
  cv::fillPoly(distance_um, std::vector<std::vector<cv::Point>>{polygon}, cv::Scalar(-band_um), cv::LINE_8, kShift);
}

// Narrows low..high to the x with |slope * (x - center) + offset| <= limit.
void narrow(float slope, float offset, float limit, float center, float& low, float& high) {
  if (std::abs(slope) < 1e-6f) {
    if (std::abs(offset) > limit) high = low - 1;
    return;
  }
  const float a = center + (-limit - offset) / slope, b = center + (limit - offset) / slope;
  low = std::max(low, std::min(a, b));
  high = std::min(high, std::max(a, b));
}

}  // namespace

void signed_distance(const Contour_um& contour_um, double pixel_size_um, const cv::Rect& window, double band_um,
                     cv::Mat1f& distance_um) {
  const Eigen::Index n = contour_um.cols();
  Contour_um points = contour_um / pixel_size_um;
  points.row(0).array() -= window.x;
  points.row(1).array() -= window.y;
  distance_um.create(window.size());
  fill_far(points, static_cast<float>(band_um), distance_um);

  // Outward is left or right of the way round, by the area's sign.
  double area = 0;
  for (Eigen::Index i = 0, j = n - 1; i < n; j = i++) area += points(0, j) * points(1, i) - points(0, i) * points(1, j);
  const float turn = area > 0 ? 1.0f : -1.0f;

  // Each segment offers its distance to the pixels about it; the nearest wins.
  const double band_px = band_um / pixel_size_um;
  cv::Mat1f nearest2(window.size(), static_cast<float>(band_px * band_px));
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2f a = points.col(i).cast<float>(), b = points.col((i + 1) % n).cast<float>();
    const Eigen::Vector2f way = b - a;
    const float length2 = way.squaredNorm();
    if (length2 <= 0) continue;
    // At a corner the two neighbours' common normal decides the side.
    const Eigen::Vector2f before = (a - points.col((i + n - 1) % n).cast<float>()).normalized();
    const Eigen::Vector2f after = (points.col((i + 2) % n).cast<float>() - b).normalized();
    const Eigen::Vector2f along = way.normalized();
    const Eigen::Vector2f normal(turn * along.y(), -turn * along.x());
    const Eigen::Vector2f at_a = normal + turn * Eigen::Vector2f(before.y(), -before.x());
    const Eigen::Vector2f at_b = normal + turn * Eigen::Vector2f(after.y(), -after.x());

    // Only a strip along the segment, a little longer than it: contours turn by less than 28 degrees from one segment
    // to the next, so every near pixel lies in the strip of the segment or vertex nearest to it.
    const auto reach = static_cast<float>(band_px);
    const float length = std::sqrt(length2), ahead = 0.25f * reach;
    const Eigen::Vector2f corner = (normal * reach).cwiseAbs() + (along * (ahead + length / 2)).cwiseAbs();
    const Eigen::Vector2f middle = (a + b) / 2;
    const int y0 = std::max(0, static_cast<int>(std::ceil(middle.y() - corner.y())));
    const int y1 = std::min(window.height - 1, static_cast<int>(std::floor(middle.y() + corner.y())));
    const float inverse_length2 = 1.0f / length2, scale = static_cast<float>(pixel_size_um);
    for (int y = y0; y <= y1; ++y) {
      float low = middle.x() - corner.x(), high = middle.x() + corner.x();
      const float dy_middle = static_cast<float>(y) - middle.y();
      narrow(along.x(), dy_middle * along.y(), ahead + length / 2, middle.x(), low, high);
      narrow(normal.x(), dy_middle * normal.y(), reach, middle.x(), low, high);
      const int x0 = std::max(0, static_cast<int>(std::ceil(low)));
      const int x1 = std::min(window.width - 1, static_cast<int>(std::floor(high)));
      float* best = nearest2[y];
      float* distance = distance_um[y];
      for (int x = x0; x <= x1; ++x) {
        const float px = static_cast<float>(x) - a.x(), py = static_cast<float>(y) - a.y();
        float t = (px * way.x() + py * way.y()) * inverse_length2;
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        const float dx = px - t * way.x(), dy = py - t * way.y(), d2 = dx * dx + dy * dy;
        if (d2 >= best[x]) continue;
        best[x] = d2;
        const Eigen::Vector2f& side = t <= 0 ? at_a : t >= 1 ? at_b : normal;
        const float magnitude = std::sqrt(d2) * scale;
        distance[x] = dx * side.x() + dy * side.y() >= 0 ? magnitude : -magnitude;
      }
    }
  }
}

}  // namespace pellucida
