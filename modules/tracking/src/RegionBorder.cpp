#include "RegionBorder.h"

#include <algorithm>

namespace pellucida {
namespace {

// Sums over a window: of ones, positions u, grey values v, and their products.
struct Moments {
  double count = 0.0, u = 0.0, uu = 0.0, v = 0.0, uv = 0.0, vv = 0.0;

  // Adds (or with sign -1 takes away) the samples from..to-1 of a normal.
  void add(const Eigen::MatrixXd& sums, int row, int from, int to, double sign) {
    const double *a = sums.col(row).data() + 6 * from, *b = sums.col(row).data() + 6 * to;
    count += sign * (b[0] - a[0]);
    u += sign * (b[1] - a[1]);
    uu += sign * (b[2] - a[2]);
    v += sign * (b[3] - a[3]);
    uv += sign * (b[4] - a[4]);
    vv += sign * (b[5] - a[5]);
  }
  double mean() const { return v / count; }
  double spread() const { return std::max(0.0, vv / count - mean() * mean()); }
  // Variance of the grey values about their own straight line along the normal.
  double variance() const {
    const double along = uu - u * u / count, slope = along > 0.0 ? (uv - u * v / count) / along : 0.0;
    return std::max(0.0, (vv - v * v / count - slope * slope * along) / count);
  }
};

}  // namespace

void RegionBorder::evidence(int half_rows, double noise, Eigen::MatrixXf& out, Eigen::MatrixXf* brightness,
                            Eigen::MatrixXf* texture) {
  const int n = rows(), m = columns(), samples = strip_.columns();
  for (Eigen::MatrixXf* each : {&out, brightness, texture})
    if (each != nullptr) each->setZero(n, std::max(m, 0));
  if (n < 1 || m < 1) return;
  half_rows = std::clamp(half_rows, 0, (n - 1) / 2);

  // Running sums along each normal, about a mid-grey so that squares lose no digits.
  const double middle = strip_.profile(0)[samples / 2];
  sums_.setZero(6 * (samples + 1), n);
  for (int i = 0; i < n; ++i) {
    const float* profile = strip_.profile(i);
    double* sum = sums_.col(i).data();
    for (int j = 0; j < samples; ++j, sum += 6) {
      const double w = valid_(j, i), u = j, v = profile[j] - middle;
      const double terms[6] = {w, w * u, w * u * u, w * v, w * u * v, w * v * v};
      for (int k = 0; k < 6; ++k) sum[6 + k] = sum[k] + terms[k];
    }
  }

  // Both windows slide round the contour, one row in and one row out at a time.
  const double full = window_ * (2.0 * half_rows + 1.0), least_variance = noise * noise + 1e-7;
  for (int j = 0; j < m; ++j) {
    const int center = j + window_;
    Moments inside, outside;
    const auto slide = [&](int row, double sign) {
      const int wrapped = (row % n + n) % n;
      inside.add(sums_, wrapped, center - window_, center, sign);
      outside.add(sums_, wrapped, center + 1, center + window_ + 1, sign);
    };
    for (int k = -half_rows; k <= half_rows; ++k) slide(k, 1.0);
    for (int i = 0; i < n; ++i) {
      if (inside.count >= 0.5 * full && outside.count >= 0.5 * full) {
        const double apart = inside.mean() - outside.mean();
        const double in = inside.variance() + least_variance, beyond = outside.variance() + least_variance;
        const double both = 0.5 * (in + beyond);
        out(i, j) = static_cast<float>(std::log((both + 0.25 * apart * apart) / std::sqrt(in * beyond)));
        if (brightness != nullptr)
          (*brightness)(i, j) = static_cast<float>(std::copysign(std::log1p(0.25 * apart * apart / both), apart));
        if (texture != nullptr)
          (*texture)(i, j) = static_cast<float>(std::copysign(std::log(both / std::sqrt(in * beyond)), in - beyond));
      }
      slide(i - half_rows, -1.0);
      slide(i + half_rows + 1, 1.0);
    }
  }
}

void RegionBorder::split(const std::vector<int>& columns, int reach, int half_rows, double noise,
                         Eigen::MatrixXf& out) const {
  const int n = rows(), samples = strip_.columns();
  half_rows = std::clamp(half_rows, 0, (n - 1) / 2);
  const double least_variance = noise * noise + 1e-7;
  out.setZero(n, 2 * reach + 1);
  for (int o = -reach; o <= reach; ++o) {
    Moments inside, outside;
    const auto slide = [&](int row, double sign) {
      const int wrapped = (row % n + n) % n, center = columns[static_cast<std::size_t>(wrapped)] + window_;
      const int cut = std::clamp(center + o, 0, samples);
      inside.add(sums_, wrapped, std::clamp(center - reach - window_, 0, cut), cut, sign);
      outside.add(sums_, wrapped, cut, std::clamp(center + reach + window_, cut, samples), sign);
    };
    for (int k = -half_rows; k <= half_rows; ++k) slide(k, 1.0);
    for (int i = 0; i < n; ++i) {
      if (inside.count >= 1.0 && outside.count >= 1.0) {
        const double cost = inside.count * std::log(inside.spread() + least_variance) +
                            outside.count * std::log(outside.spread() + least_variance);
        out(i, o + reach) = static_cast<float>(-0.5 * cost / (inside.count + outside.count));
      }
      slide(i - half_rows, -1.0);
      slide(i + half_rows + 1, 1.0);
    }
  }
  for (int i = 0; i < n; ++i) out.row(i).array() -= out.row(i).maxCoeff();
}

}  // namespace pellucida
