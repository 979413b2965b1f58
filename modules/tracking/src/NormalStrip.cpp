#include "NormalStrip.h"

namespace pellucida {

void NormalStrip::sample(const GrayImage& image, const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals,
                         double inward_px, double outward_px, double step_px) {
  inward_px_ = inward_px;
  step_px_ = step_px;
  const int columns = static_cast<int>(std::floor((inward_px + outward_px) / step_px)) + 1;
  values_.resize(columns, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double nx = normals(0, i), ny = normals(1, i);
    double x = points(0, i) - inward_px * nx, y = points(1, i) - inward_px * ny;
    float* out = values_.col(i).data();
    for (int j = 0; j < columns; ++j) {
      out[j] = image.sample(x, y);
      x += step_px * nx;
      y += step_px * ny;
    }
  }
}

void NormalStrip::features(const EdgeFilter& filter, int smoothing, Eigen::MatrixXf& out) const {
  const int n = rows(), m = columns();
  out.resize(n, m);
  Eigen::VectorXf feature(m);
  for (int i = 0; i < n; ++i) {
    filter.apply(profile(i), m, feature.data());
    out.row(i) = feature.transpose();
  }
  for (int round = 0; round < smoothing; ++round) {
    scratch_ = out;
    for (int i = 0; i < n; ++i) {
      out.row(i) = 0.5F * scratch_.row(i) +
                   0.25F * (scratch_.row(i == 0 ? n - 1 : i - 1) + scratch_.row(i + 1 == n ? 0 : i + 1));
    }
  }
}

}  // namespace pellucida
