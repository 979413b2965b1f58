#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/core/Table.h"

namespace pellucida::test {

/// Distance from a point to a closed polyline, um.
inline double distance_um(const Eigen::Vector2d& point, const Contour_um& contour_um) {
  double best = std::numeric_limits<double>::infinity();
  const Eigen::Index n = contour_um.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = contour_um.col(i);
    const Eigen::Vector2d edge = contour_um.col((i + 1) % n) - a;
    const double length2 = edge.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((point - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
    best = std::min(best, (a + share * edge - point).norm());
  }
  return best;
}

/// Root mean square of the distances from the points of one contour to the other curve, the larger of both ways, um: a
/// contour that cuts a dimple's corner is caught by the way back.
inline double rms_distance_um(const Contour_um& one, const Contour_um& other) {
  const auto one_way = [](const Contour_um& from, const Contour_um& to) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < from.cols(); ++i) sum += std::pow(distance_um(from.col(i), to), 2);
    return std::sqrt(sum / static_cast<double>(from.cols()));
  };
  return std::max(one_way(one, other), one_way(other, one));
}

/// Contours of a CSV `frame,membrane,point,x_um,y_um`, by (frame, membrane).
inline std::map<std::pair<long, int>, Contour_um> read_contours(const std::string& file) {
  const Table table = Table::read(file);
  const auto frame = table.column("frame");
  const auto membrane = table.column("membrane");
  const auto x_um = table.column("x_um");
  const auto y_um = table.column("y_um");
  std::map<std::pair<long, int>, std::vector<Eigen::Vector2d>> points;
  for (Eigen::Index i = 0; i < table.rows(); ++i) {
    points[{std::lround(frame[i]), static_cast<int>(membrane[i])}].emplace_back(x_um[i], y_um[i]);
  }
  std::map<std::pair<long, int>, Contour_um> contours;
  for (const auto& [key, list] : points) {
    Contour_um contour_um(2, static_cast<Eigen::Index>(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) contour_um.col(static_cast<Eigen::Index>(i)) = list[i];
    contours[key] = contour_um;
  }
  return contours;
}

}  // namespace pellucida::test
