#include "OutlineShape.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pellucida {
namespace {

// Set on films 26001 to 28040 of validation: cells had medians up to 0.023 and nine tenths within 0.085, ends of
// holding pipettes 0.041 to 0.082 and 0.20 to 0.21; an oval of aspect 1.15 has 0.05 and 0.07.
constexpr double kOffMedian = 0.035, kOffMost = 0.19;

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

OutlineShape::OutlineShape(const Eigen::Matrix2Xd& points, const contour::Circle& circle) {
  std::vector<double> off(static_cast<std::size_t>(points.cols()));
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    off[static_cast<std::size_t>(i)] = std::abs((points.col(i) - circle.center).norm() - circle.radius) / circle.radius;
  median_ = quantile(off, 0.5);
  most_ = quantile(off, 0.9);
}

double OutlineShape::roundness() const noexcept {
  return std::clamp(1.8 - 20.0 * median_, 0.3, 1.0);
}

bool OutlineShape::may_be_cell() const noexcept {
  return median_ < kOffMedian || most_ < kOffMost;
}

}  // namespace pellucida
