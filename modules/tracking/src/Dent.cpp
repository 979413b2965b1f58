#include "Dent.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ContourMath.h"

namespace pellucida {
namespace {

using Harmonics = Eigen::Matrix<double, 5, 1>;  // circle, shift, ellipse

constexpr double kBesideHolder = 0.5;    // cosine of 60 degrees
constexpr double kUsual_ratio = 0.02;    // of the radius: how far a membrane lies off its ellipse without a needle
constexpr int kRounds = 8;               // of weighing what lies off less, at most
constexpr double kSettled_ratio = 1e-7;  // of the radius: a change below ends them

// A point of the outline as seen from the centre: its distance, as a share of the radius, and its direction's
// harmonics.
struct Ray {
  Ray(const Eigen::Vector2d& from_center, double radius) {
    const double length = from_center.norm(), c = from_center.x() / length, s = from_center.y() / length;
    distance_ratio = length / radius;
    shape << 1.0, c, s, c * c - s * s, 2.0 * c * s;
  }
  double off(const Harmonics& fitted) const { return distance_ratio - fitted.dot(shape); }
  double distance_ratio;
  Harmonics shape;
};

}  // namespace

double dent_ratio(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& center,
                  const std::optional<Eigen::Vector2d>& holder) {
  const Eigen::Index n = outline.cols();
  if (n < 24) return 0.0;
  const double radius = (outline.colwise() - center).colwise().norm().mean();
  if (!(radius > 0.0)) return 0.0;

  // The distance outside of the fitted ellipse, as a share of the radius.
  Harmonics fitted = Harmonics::Zero();
  fitted[0] = 1.0;
  std::vector<Ray> rays;
  rays.reserve(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) rays.emplace_back(outline.col(i) - center, radius);
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix<double, 5, 5> normal = 1e-9 * Eigen::Matrix<double, 5, 5>::Identity();
    Harmonics right = Harmonics::Zero();
    for (const Ray& point : rays) {
      const double off = point.off(fitted) / kUsual_ratio, root = 1.0 / (1.0 + off * off), weight = root * root;
      normal += weight * point.shape * point.shape.transpose();
      right += weight * point.distance_ratio * point.shape;
    }
    const Harmonics before = fitted;
    fitted = normal.ldlt().solve(right);
    if ((fitted - before).cwiseAbs().maxCoeff() < kSettled_ratio) break;
  }

  const Eigen::Index half = std::max<Eigen::Index>(1, n / 60);
  const auto off = [&](Eigen::Index i) { return rays[static_cast<std::size_t>(contour::wrap(i, n))].off(fitted); };
  double deepest = 0.0, sum = 0.0;  // of a window about point i
  for (Eigen::Index k = -half; k <= half; ++k) sum += off(k);
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool is_held = holder && (outline.col(i) - center).normalized().dot(*holder) > kBesideHolder;
    if (!is_held) deepest = std::max(deepest, -sum / static_cast<double>(2 * half + 1));
    sum += off(i + half + 1) - off(i - half);
  }
  return deepest;
}

}  // namespace pellucida
