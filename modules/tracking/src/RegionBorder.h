#pragma once
#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "NormalStrip.h"

namespace pellucida {

/// The border between two regions that differ in brightness or in texture, of either sign: the soft outer edge of a
/// zona, which no dark line marks and which oblique light makes brighter on one side and darker on the other.
///
/// Evidence at offset u on a normal, with the samples of two windows of `window_px` just inside and just outside of u,
/// on this normal and its neighbours: the log-likelihood ratio, per sample, of two Gaussians against one,
///
///     E = ln s^2 - (ln s_in^2 + ln s_out^2) / 2,    s^2 = (s_in^2 + s_out^2) / 2 + (m_in - m_out)^2 / 4
///
/// with mean m and variance s^2 of each window. The variance is taken about the window's own slope along the normal, so
/// that a blurred step has its maximum in its middle; pixel noise is the least variance. E >= 0, 0 where both look
/// alike: the contrast is measured in units of the regions' own texture.
class RegionBorder {
 public:
  /// Samples `image` (GrayImage or FrameSampler) along the outward unit normals of `points` (2 x n), for evidence at
  /// offsets from -inward_px to +outward_px. Samples outside the image do not count.
  template <class Image>
  void sample(const Image& image, const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals, double inward_px,
              double outward_px, double step_px, double window_px) {
    window_ = std::max(2, static_cast<int>(std::lround(window_px / step_px)));
    const double extra = window_ * step_px;
    strip_.sample(image, points, normals, inward_px + extra, outward_px + extra, step_px);
    valid_.resize(strip_.columns(), strip_.rows());
    for (int i = 0; i < strip_.rows(); ++i)
      for (int j = 0; j < strip_.columns(); ++j)
        valid_(j, i) = image.inside(points.col(i) + strip_.offset_of(j) * normals.col(i), 0.5) ? 1.0F : 0.0F;
  }

  /// E at every normal and offset (rows x columns), from windows that take in `half_rows` neighbours on either side.
  /// 0 where less than half of a window lies in the image. `noise`: standard deviation of a pixel.
  void evidence(int half_rows, double noise, Eigen::MatrixXf& out) {
    evidence(half_rows, noise, out, nullptr, nullptr);
  }

  /// The same, with its two parts signed: evidence of brightness (positive where it is brighter inside) and of texture
  /// (positive where it is rougher inside). Both (rows x columns).
  void evidence(int half_rows, double noise, Eigen::MatrixXf& out, Eigen::MatrixXf* brightness,
                Eigen::MatrixXf* texture);

  /// Where the border lies best, once it is roughly known: `columns` (one for each row). The piece of each normal
  /// within `reach` + window of that column is split at each offset of -reach..reach samples; out (rows x 2 reach + 1)
  /// is the log-likelihood of two Gaussians per sample of the piece, less the best of its row. Unlike `evidence`, whose
  /// windows move along, it compares splits of the same samples and has no bias towards the smoother side. Call after
  /// `evidence`; columns must leave room for reach + window on both sides of the sampled strip.
  void split(const std::vector<int>& columns, int reach, int half_rows, double noise, Eigen::MatrixXf& out) const;

  int rows() const noexcept { return strip_.rows(); }
  int columns() const noexcept { return strip_.columns() - 2 * window_; }
  double offset_of(double column) const noexcept { return strip_.offset_of(column + window_); }
  double column_of(double offset) const noexcept { return strip_.column_of(offset) - window_; }
  /// Whether the sample at row i, column j lies in the image.
  bool inside(int i, int j) const noexcept { return valid_(j + window_, i) > 0.0F; }

 private:
  NormalStrip strip_;
  Eigen::MatrixXf valid_;  // (samples x rows), 1 inside the image
  Eigen::MatrixXd sums_;   // six running sums along each normal, (6 (samples + 1) x rows)
  int window_ = 2;
};

}  // namespace pellucida
