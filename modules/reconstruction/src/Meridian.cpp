#include "Meridian.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace pellucida {
namespace {

// Where the contour crosses the axis line: on the segment after point `index`, at `height` along the axis.
struct Crossing {
  Eigen::Index index = -1;
  double height_um = 0.0;
};

// The ends of the body on the axis. The axis enters the contour at every second crossing from the far end on; of the
// stretches inside, the body is the one that holds the centre or, where the dimple is deeper than the centre, the
// longest: others are the lips of the dimple.
struct Poles {
  Crossing needle;
  Crossing far;
};

std::vector<Crossing> crossings_by_height(const Eigen::Matrix2Xd& local) {
  std::vector<Crossing> crossings;
  const Eigen::Index n = local.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = local.col(i);
    const Eigen::Vector2d b = local.col((i + 1) % n);
    if ((a.y() >= 0.0) == (b.y() >= 0.0)) continue;
    crossings.push_back({i, a.x() + (b.x() - a.x()) * a.y() / (a.y() - b.y())});
  }
  std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.height_um < b.height_um; });
  return crossings;
}

std::optional<Poles> find_poles(const Eigen::Matrix2Xd& local) {
  const std::vector<Crossing> crossings = crossings_by_height(local);
  std::optional<Poles> longest;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const Poles poles{.needle = crossings[i + 1], .far = crossings[i]};
    if (poles.far.height_um < 0.0 && poles.needle.height_um > 0.0) return poles;
    const double length_um = poles.needle.height_um - poles.far.height_um;
    if (!longest || length_um > longest->needle.height_um - longest->far.height_um) longest = poles;
  }
  return longest;
}

// The points from one pole to the other, following the contour one way.
std::vector<Eigen::Vector2d> walk(const Eigen::Matrix2Xd& local, const Crossing& from, const Crossing& to,
                                  bool forward) {
  const Eigen::Index n = local.cols();
  std::vector<Eigen::Vector2d> path{{from.height_um, 0.0}};
  if (forward) {
    for (Eigen::Index i = (from.index + 1) % n;; i = (i + 1) % n) {
      path.emplace_back(local.col(i));
      if (i == to.index) break;
    }
  } else {
    for (Eigen::Index i = from.index;; i = (i + n - 1) % n) {
      path.emplace_back(local.col(i));
      if (i == (to.index + 1) % n) break;
    }
  }
  path.emplace_back(to.height_um, 0.0);
  return path;
}

// The path at the given fractions of its arc length, linear between its points.
Eigen::Matrix2Xd resample(const std::vector<Eigen::Vector2d>& path, const Eigen::VectorXd& arc_fraction) {
  std::vector<double> arc_um(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) arc_um[i] = arc_um[i - 1] + (path[i] - path[i - 1]).norm();

  Eigen::Matrix2Xd samples(2, arc_fraction.size());
  std::size_t segment = 1;
  for (Eigen::Index j = 0; j < arc_fraction.size(); ++j) {
    const double target_um = arc_fraction[j] * arc_um.back();
    while (segment + 1 < path.size() && arc_um[segment] < target_um) ++segment;
    const double length_um = arc_um[segment] - arc_um[segment - 1];
    const double share = length_um > 0.0 ? (target_um - arc_um[segment - 1]) / length_um : 0.0;
    samples.col(j) = path[segment - 1] + share * (path[segment] - path[segment - 1]);
  }
  return samples;
}

double mean_side(const std::vector<Eigen::Vector2d>& path) {
  double sum = 0.0;
  for (const auto& point : path) sum += point.y();
  return sum;
}

}  // namespace

Eigen::VectorXd graded_fractions(int count, double pole_density_ratio) {
  const Eigen::ArrayXd u = Eigen::ArrayXd::LinSpaced(count, 0.0, 1.0);
  return (pole_density_ratio * u + (1.0 - pole_density_ratio) * u.square()).matrix();
}

expected<MeridianPair, std::string> cut_meridians(const Contour_um& contour_um, const Eigen::Vector2d& center_um,
                                                  const Eigen::Vector2d& axis, const Eigen::VectorXd& arc_fraction) {
  if (contour_um.cols() < 8) return unexpected<std::string>("the contour has fewer than 8 points");
  if (!contour_um.allFinite() || !center_um.allFinite() || !axis.allFinite()) {
    return unexpected<std::string>("the contour or its axis has a number that is not finite");
  }

  // Local coordinates: height along the axis, signed distance from it.
  Eigen::Matrix2d to_local;
  to_local.row(0) = axis.transpose();
  to_local.row(1) = Eigen::RowVector2d(-axis.y(), axis.x());
  const Eigen::Matrix2Xd local = to_local * (contour_um.colwise() - center_um);

  if (local.row(0).maxCoeff() <= 0.0 || local.row(0).minCoeff() >= 0.0) {
    return unexpected<std::string>("the contour lies wholly to one side of the cell's centre");
  }
  const std::optional<Poles> poles = find_poles(local);
  if (!poles) return unexpected<std::string>("the axis through the cell's centre does not cross the contour");

  // Two ways round from pole to pole; which is the positive side depends on the contour's sense.
  auto one = walk(local, poles->needle, poles->far, true);
  auto other = walk(local, poles->needle, poles->far, false);
  if (mean_side(one) < mean_side(other)) std::swap(one, other);

  MeridianPair pair;
  pair.arc_fraction = arc_fraction;
  pair.positive = resample(one, arc_fraction);
  pair.negative = resample(other, arc_fraction);
  pair.negative.row(1) *= -1.0;
  return pair;
}

}  // namespace pellucida
