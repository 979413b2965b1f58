#include "CellPath.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace pellucida {
namespace {

float smooth_step(float t) noexcept {
  t = std::clamp(t, 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

double signed_area(const Contour_um& contour) noexcept {
  double area = 0;
  for (Eigen::Index i = 0, j = contour.cols() - 1; i < contour.cols(); j = i++)
    area += contour(0, j) * contour(1, i) - contour(0, i) * contour(1, j);
  return area / 2;
}

}  // namespace

Contour_um offset_contour(const Contour_um& contour, double outwards_um) {
  const Eigen::Index n = contour.cols();
  Contour_um moved(2, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Vector2d tangent = (contour.col((k + 1) % n) - contour.col((k + n - 1) % n)).normalized();
    moved.col(k) = contour.col(k) + outwards_um * Eigen::Vector2d(-tangent.y(), tangent.x());
  }
  return moved;
}

// Half a pixel or finer, but no finer than the section's own rounding.
CellPath::CellPath(const Look::Cell& look, double pixel_size_um)
    : look_(look), pixel_size_um_(pixel_size_um), step_um_(std::clamp(0.5 * pixel_size_um, 0.2, 0.6)) {}

double CellPath::axis_x_um(double z_um) const noexcept {
  return offset_um_ * smooth_step(static_cast<float>(z_um / radius_um_ + 0.3));
}

void CellPath::cross(const Contour_um& contour) {
  for (Row& row : rows_)
    for (auto& side : row.side) side.clear();
  const double turn = signed_area(contour) > 0 ? 1.0 : -1.0;
  for (Eigen::Index i = 0, j = contour.cols() - 1; i < contour.cols(); j = i++) {
    const double za = (contour(1, j) - z0_um_) / step_um_, zb = (contour(1, i) - z0_um_) / step_um_;
    const int first = static_cast<int>(std::ceil(std::min(za, zb))),
              last = static_cast<int>(std::ceil(std::max(za, zb)));
    for (int k = std::max(first, 0); k < std::min(last, static_cast<int>(rows_.size())); ++k) {
      const double part = (k - za) / (zb - za), x = contour(0, j) + part * (contour(0, i) - contour(0, j));
      const double from_axis = x - axis_x_um(z0_um_ + k * step_um_);
      const bool above = from_axis >= 0;
      const double sign = turn * (zb > za ? 1.0 : -1.0) * (above ? 1.0 : -1.0);
      rows_[static_cast<std::size_t>(k)].side[above ? 1 : 0].push_back(
          {static_cast<float>(std::abs(from_axis)), static_cast<float>(sign)});
    }
  }
}

void CellPath::add_thickness(const Contour_um& contour, float weight, cv::Mat1f& thickness_um) {
  cross(contour);
  // So far from the axis both sides have a say.
  const auto blend_um = static_cast<float>(0.35 * radius_um_), step = static_cast<float>(step_um_);
  const auto add_rings = [](const std::vector<Crossing>& rings, float v0, float step_um, int count, float* sum) {
    for (const Crossing& ring : rings) {
      const float r2 = ring.radius_um * ring.radius_um, sign = 2 * ring.sign;
      for (int j = 0; j < count; ++j) {
        const float v = v0 + step_um * static_cast<float>(j), u = r2 - v * v;
        sum[j] += sign * std::sqrt(u > 0.0f ? u : 0.0f);
      }
    }
  };
  for (int k = 0; k < thickness_um.rows; ++k) {
    const Row& row = rows_[static_cast<std::size_t>(k)];
    if (row.side[0].empty() && row.side[1].empty()) continue;
    const double axis = axis_x_um(z0_um_ + k * step_um_) - x0_um_;
    const int middle = std::clamp(static_cast<int>(std::ceil(axis / step_um_)), 0, thickness_um.cols);
    for (int s = 0; s < 2; ++s) {
      // Columns of this side, in order.
      const int first = s == 0 ? 0 : middle, last = s == 0 ? middle : thickness_um.cols, count = last - first;
      const auto v0 = static_cast<float>(first * step_um_ - axis);
      chord_.assign(static_cast<std::size_t>(count), 0.0f);
      other_.assign(static_cast<std::size_t>(count), 0.0f);
      add_rings(row.side[s], v0, step, count, chord_.data());
      add_rings(row.side[1 - s], v0, step, count, other_.data());
      float reach = 0;
      for (const Crossing& ring : row.side[s]) reach = std::max(reach, ring.radius_um);
      const float blend = reach > 0 ? std::min(blend_um, reach) : blend_um;
      float* out = thickness_um[k] + first;
      for (int j = 0; j < count; ++j) {
        const float own = 0.5f + 0.5f * smooth_step(std::abs(v0 + step * static_cast<float>(j)) / blend);
        const auto i = static_cast<std::size_t>(j);
        out[j] += weight * (own * chord_[i] + (1 - own) * other_[i]);
      }
    }
  }
}

void CellPath::add(OpticalPath& path, const MicroscopeCell& cell) {
  // The section's box with a margin.
  const double margin_um = look_.zona_softness_um + 4 * step_um_ + 2 * pixel_size_um_;
  const Eigen::Vector2d low = cell.outer_um.rowwise().minCoeff().array() - margin_um,
                        high = cell.outer_um.rowwise().maxCoeff().array() + margin_um;
  x0_um_ = low.x();
  z0_um_ = low.y();
  offset_um_ = cell.needle_offset_um;
  radius_um_ = 0.25 * (high - low).sum();
  const int columns = static_cast<int>((high.x() - low.x()) / step_um_) + 1,
            rows = static_cast<int>((high.y() - low.y()) / step_um_) + 1;
  rows_.resize(static_cast<std::size_t>(rows));
  for (cv::Mat1f* table : {&zona_um_, &ooplasm_um_}) {
    table->create(rows, columns);
    table->setTo(0);
  }

  // The zona: outside less inside; a soft one is a pile of thin shells.
  if (look_.zona_softness_um > 0) {
    constexpr int kShells = 5;
    for (int k = 0; k < kShells; ++k)
      add_thickness(offset_contour(cell.outer_um, look_.zona_softness_um * ((k + 0.5) / kShells - 0.5)), 1.0f / kShells,
                    zona_um_);
  } else {
    add_thickness(cell.outer_um, 1.0f, zona_um_);
  }
  add_thickness(cell.inner_um, -1.0f, zona_um_);
  add_thickness(cell.ooplasm_um, 1.0f, ooplasm_um_);

  phase_ = kPhase_rad_per_um * (look_.zona_index * zona_um_ + look_.ooplasm_index * ooplasm_um_);
  loss_ = 1e-3 * (look_.zona_absorption_per_mm * zona_um_ + look_.ooplasm_absorption_per_mm * ooplasm_um_);

  // Smoothed as a pixel does, then read at the image's pixels.
  const double blur = std::max(0.45 * pixel_size_um_ / step_um_, 0.7);
  const Eigen::Vector2d dx = pixel_size_um_ * Eigen::Vector2d::UnitX(), dy = pixel_size_um_ * Eigen::Vector2d::UnitY();
  const auto to_table = [&](const Eigen::Vector2d& step) -> Eigen::Vector2d {
    return Eigen::Vector2d(step.dot(cell.across), step.dot(cell.axis)) / step_um_;
  };
  const Eigen::Vector2d a = to_table(dx), b = to_table(dy),
                        c = to_table(-cell.center_um) - Eigen::Vector2d(x0_um_, z0_um_) / step_um_;

  // Only the window about the cell.
  cv::Point2d first(1e9, 1e9), last(-1e9, -1e9);
  for (const double x : {low.x(), high.x()})
    for (const double z : {low.y(), high.y()}) {
      const Eigen::Vector2d corner = cell.to_image({x, z}) / pixel_size_um_;
      first = {std::min(first.x, corner.x()), std::min(first.y, corner.y())};
      last = {std::max(last.x, corner.x()), std::max(last.y, corner.y())};
    }
  const cv::Rect window =
      cv::Rect(cv::Point(cvFloor(first.x), cvFloor(first.y)), cv::Point(cvCeil(last.x) + 1, cvCeil(last.y) + 1)) &
      cv::Rect({}, path.phase_rad.size());
  if (window.empty()) return;
  const Eigen::Vector2d origin = c + window.x * a + window.y * b;
  const cv::Matx23d from_image(a.x(), b.x(), origin.x(), a.y(), b.y(), origin.y());
  for (auto [table, layer] : {std::pair{&phase_, &path.phase_rad}, std::pair{&loss_, &path.absorbance}}) {
    cv::GaussianBlur(*table, *table, {}, blur, blur, cv::BORDER_REPLICATE);
    cv::warpAffine(*table, drawn_, from_image, window.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                   cv::BORDER_CONSTANT, 0);
    (*layer)(window) += drawn_;
  }
}

}  // namespace pellucida
