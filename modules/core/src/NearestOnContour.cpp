#include "pellucida/core/NearestOnContour.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pellucida/core/Statistics.h"

namespace pellucida {
namespace {

/// A contour farther from a node than this is no view of it.
constexpr double kFarthest_um = 15.0;
/// Contour points less sure than this say nothing.
constexpr double kLeastConfidence = 0.2;

}  // namespace

Nearest nearest_on(const Contour_um& contour, const Eigen::Vector2d& place_um) {
  Nearest best;
  double best_square = std::numeric_limits<double>::infinity();
  const Eigen::Index n = contour.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = contour.col(i), ab = contour.col(i + 1 < n ? i + 1 : 0) - a;
    const double square = ab.squaredNorm();
    const double t = square > 0.0 ? std::clamp(ab.dot(place_um - a) / square, 0.0, 1.0) : 0.0;
    const Eigen::Vector2d q = a + t * ab;
    const double distance_square = (place_um - q).squaredNorm();
    if (distance_square < best_square) {
      best_square = distance_square;
      best.place_um = q;
      best.segment = i;
    }
  }
  best.distance_um = std::sqrt(best_square);
  return best;
}

double offset_of(const MembraneContour& contour, const Eigen::Vector2d& place_um, const Eigen::Vector2d& normal) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (contour.points_um.cols() < 3) return kNone;
  const Nearest near = nearest_on(contour.points_um, place_um);
  if (near.distance_um > kFarthest_um) return kNone;
  if (contour.confidence.size() == contour.points_um.cols() && contour.confidence[near.segment] < kLeastConfidence)
    return kNone;
  return normal.dot(near.place_um - place_um);
}

double usual_sigma_um(const MembraneContour& contour) {
  std::vector<double> sigmas(contour.sigma_um.begin(), contour.sigma_um.end());
  if (sigmas.empty()) return 0.0;
  std::sort(sigmas.begin(), sigmas.end());
  return quantile(sigmas, 0.5);
}

}  // namespace pellucida
