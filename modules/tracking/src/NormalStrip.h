#pragma once
#include <Eigen/Core>

#include "GrayImage.h"
#include "pellucida/tracking/EdgeProfile.h"

namespace pellucida {

/// Samples along the normals of a contour: the only pixels a snake looks at.
/// Row i belongs to point i, column j to the offset (j * step_px - inward_px) along the outward normal.
class NormalStrip {
 public:
  /// Samples `image` along the outward normals of `points` (px, closed, positive area) from -inward_px to +outward_px.
  void sample(const GrayImage& image, const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals, double inward_px,
              double outward_px, double step_px);

  /// The edge feature of every row, smoothed over neighbouring rows by (1 2 1) / 4 `smoothing` times, (rows x columns).
  void features(const EdgeFilter& filter, int smoothing, Eigen::MatrixXf& out) const;

  int rows() const noexcept { return static_cast<int>(values_.cols()); }
  int columns() const noexcept { return static_cast<int>(values_.rows()); }
  double offset_of(double column) const noexcept { return column * step_px_ - inward_px_; }
  double column_of(double offset) const noexcept { return (offset + inward_px_) / step_px_; }
  double step_px() const noexcept { return step_px_; }
  const float* profile(int row) const noexcept { return values_.col(row).data(); }

 private:
  Eigen::MatrixXf values_;  // (columns x rows): one profile is contiguous
  mutable Eigen::MatrixXf scratch_;
  double inward_px_ = 0.0;
  double step_px_ = 0.5;
};

}  // namespace pellucida
