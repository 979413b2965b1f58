#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "EdgeProfile.h"

namespace pellucida {

/// Samples along the normals of a contour: the only pixels a snake looks at.
/// Row i belongs to point i, column j to the offset (j * step_px - inward_px) along the outward normal.
class NormalStrip {
 public:
  /// Samples `image` (FrameSampler or GrayImage) along the outward normals of `points` (px, closed, positive area) from
  /// -inward_px to +outward_px.
  template <class Image>
  void sample(const Image& image, const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals, double inward_px,
              double outward_px, double step_px) {
    inward_px_ = inward_px;
    step_px_ = step_px;
    const int columns = static_cast<int>(std::floor((inward_px + outward_px) / step_px)) + 1;
    values_.resize(columns, points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      image.sample_line(points.col(i) - inward_px * normals.col(i), step_px * normals.col(i), columns,
                        values_.col(i).data());
  }

  /// The edge feature of every row, smoothed over neighbouring rows by (1 2 1) / 4 `smoothing` times, (rows x columns).
  void features(const EdgeFilter& filter, int smoothing, Eigen::MatrixXf& out) const;

  int rows() const noexcept { return static_cast<int>(values_.cols()); }
  int columns() const noexcept { return static_cast<int>(values_.rows()); }
  double offset_of(double column) const noexcept { return column * step_px_ - inward_px_; }
  double column_of(double offset) const noexcept { return (offset + inward_px_) / step_px_; }
  double step_px() const noexcept { return step_px_; }
  /// Between the samples, linearly; beyond them the last one.
  double value(int row, double column) const noexcept {
    const int whole = std::clamp(static_cast<int>(column), 0, columns() - 2);
    const double t = std::clamp(column - whole, 0.0, 1.0);
    return (1.0 - t) * values_(whole, row) + t * values_(whole + 1, row);
  }
  const float* profile(int row) const noexcept { return values_.col(row).data(); }

 private:
  Eigen::MatrixXf values_;  // (columns x rows): one profile is contiguous
  mutable Eigen::MatrixXf scratch_;
  double inward_px_ = 0.0;
  double step_px_ = 0.5;
};

}  // namespace pellucida
