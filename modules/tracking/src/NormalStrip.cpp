#include "NormalStrip.h"

namespace pellucida {

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
