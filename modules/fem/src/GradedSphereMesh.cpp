#include "GradedSphereMesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <queue>
#include <string>

#include "HemispherePatch.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr std::size_t kMostNodes = 200000;
/// Triangles larger than so many equilateral ones of the edge length asked for are split: first the very large ones,
/// then ever smaller ones, evened out in between. At the last limit the mean edge comes out as asked for.
constexpr double kFirstArea = 64.0, kLastArea = 1.27, kAreaRatio = 0.97;
constexpr int kRoundsBetween = 8, kLastRounds = 60;

Eigen::Vector3d section_point(double angle_rad) {
  return {std::sin(angle_rad), 0.0, std::cos(angle_rad)};
}

/// Nodes of the section y = 0: as many to the length as 1 / edge length, integrated round the circle, says.
std::vector<Eigen::Vector3d> section_nodes(double radius_um, double start_angle_rad, const EdgeLength& edge_length_um) {
  constexpr int kSteps = 20000;
  std::vector<double> cumulative(kSteps + 1, 0.0);
  for (int k = 0; k < kSteps; ++k) {
    const double angle = start_angle_rad + 2.0 * std::numbers::pi * (k + 0.5) / kSteps;
    const double length = edge_length_um(radius_um * section_point(angle));
    if (!(length > 0.0)) throw UsageError("sphere mesh: an edge length must be above 0 um");
    cumulative[static_cast<std::size_t>(k) + 1] =
        cumulative[static_cast<std::size_t>(k)] + 2.0 * std::numbers::pi * radius_um / kSteps / length;
  }
  if (cumulative.back() > static_cast<double>(kMostNodes)) throw UsageError("sphere mesh: the edges are too short");

  const int count = std::max(6, static_cast<int>(std::lround(cumulative.back())));
  std::vector<Eigen::Vector3d> nodes;
  std::size_t cell = 0;
  for (int n = 0; n < count; ++n) {
    const double target = cumulative.back() * n / count;
    while (cumulative[cell + 1] < target) ++cell;
    const double part = (target - cumulative[cell]) / (cumulative[cell + 1] - cumulative[cell]);
    nodes.push_back(
        section_point(start_angle_rad + 2.0 * std::numbers::pi * (static_cast<double>(cell) + part) / kSteps));
  }
  return nodes;
}

class Filling {
 public:
  Filling(double radius_um, const EdgeLength& edge_length_um, const std::vector<Eigen::Vector3d>& border)
      : radius_um_(radius_um), edge_length_um_(edge_length_um), patch_(border) {}

  const HemispherePatch& patch() const noexcept { return patch_; }

  /// Splits triangles, the largest in terms of the area asked for first, until none is above `largest_area` of those.
  void split_above(double largest_area) {
    std::priority_queue<std::pair<double, int>> queue;
    for (int t = 0; t < static_cast<int>(patch_.triangles().size()); ++t) queue.emplace(excess(t), t);
    std::vector<int> changed;
    while (!queue.empty() && queue.top().first > largest_area) {
      const auto [size, t] = queue.top();
      queue.pop();
      if (size != excess(t)) continue;  // it was changed, and is in the queue once more
      if (patch_.points().size() > kMostNodes) throw UsageError("sphere mesh: the edges are too short");
      changed.clear();
      patch_.split(t, changed);
      for (const int c : changed) queue.emplace(excess(c), c);
    }
  }

  /// Moves each inner node to the mean of its triangles' middles, each weighing as its area in terms of the area asked
  /// for there.
  void even_out() {
    const auto& points = patch_.points();
    std::vector<Eigen::Vector3d> sum(points.size(), Eigen::Vector3d::Zero());
    std::vector<double> weight(points.size(), 0.0);
    for (int t = 0; t < static_cast<int>(patch_.triangles().size()); ++t) {
      const Eigen::Vector3d centre = middle(t);
      const double w = excess(t);
      for (const int node : patch_.triangles()[static_cast<std::size_t>(t)].nodes) {
        sum[static_cast<std::size_t>(node)] += w * centre;
        weight[static_cast<std::size_t>(node)] += w;
      }
    }
    std::vector<Eigen::Vector3d> moved;
    for (auto n = static_cast<std::size_t>(patch_.border_count()); n < points.size(); ++n) {
      moved.push_back((sum[n] / weight[n]).normalized());
    }
    patch_.move_inner(moved);
  }

 private:
  Eigen::Vector3d middle(int triangle) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int n : patch_.triangles()[static_cast<std::size_t>(triangle)].nodes) {
      sum += patch_.points()[static_cast<std::size_t>(n)];
    }
    return sum.normalized();
  }

  /// Area in terms of the equilateral triangle asked for.
  double excess(int triangle) const {
    const auto& nodes = patch_.triangles()[static_cast<std::size_t>(triangle)].nodes;
    const Eigen::Vector3d& a = patch_.points()[static_cast<std::size_t>(nodes[0])];
    const Eigen::Vector3d& b = patch_.points()[static_cast<std::size_t>(nodes[1])];
    const Eigen::Vector3d& c = patch_.points()[static_cast<std::size_t>(nodes[2])];
    const double length = edge_length_um_(radius_um_ * middle(triangle)) / radius_um_;
    return 0.5 * (b - a).cross(c - a).norm() / (0.25 * std::sqrt(3.0) * length * length);
  }

  double radius_um_;
  const EdgeLength& edge_length_um_;
  HemispherePatch patch_;
};

}  // namespace

GradedSphere make_graded_sphere_mesh(double radius_um, double start_angle_rad, const EdgeLength& edge_length_um) {
  if (!(radius_um > 0.0)) throw UsageError("sphere mesh: the radius must be above 0 um");
  const auto border = section_nodes(radius_um, start_angle_rad, edge_length_um);
  Filling filling(radius_um, edge_length_um, border);
  for (double area = kFirstArea; area > kLastArea; area *= kAreaRatio) {
    filling.split_above(area);
    for (int round = 0; round < kRoundsBetween; ++round) filling.even_out();
  }
  filling.split_above(kLastArea);
  for (int round = 0; round < kLastRounds; ++round) filling.even_out();

  // Nodes of the section first, then one half's, then their images.
  const auto& points = filling.patch().points();
  const auto& triangles = filling.patch().triangles();
  const auto rim = static_cast<Eigen::Index>(border.size());
  const Eigen::Index inner = static_cast<Eigen::Index>(points.size()) - rim;
  GradedSphere sphere;
  sphere.meridian_count = static_cast<int>(rim);
  sphere.mesh.points_um.resize(3, rim + 2 * inner);
  for (Eigen::Index n = 0; n < rim + inner; ++n) {
    const Eigen::Vector3d p = radius_um * points[static_cast<std::size_t>(n)];
    sphere.mesh.points_um.col(n) = p;
    if (n >= rim) sphere.mesh.points_um.col(n + inner) << p.x(), -p.y(), p.z();
  }

  // The mirror image runs the other way round.
  const auto count = static_cast<Eigen::Index>(triangles.size());
  sphere.mesh.triangles.resize(3, 2 * count);
  const auto image = [&](int node) { return node < rim ? node : node + static_cast<int>(inner); };
  for (Eigen::Index t = 0; t < count; ++t) {
    const auto& n = triangles[static_cast<std::size_t>(t)].nodes;
    sphere.mesh.triangles.col(t) << n[0], n[1], n[2];
    sphere.mesh.triangles.col(count + t) << image(n[0]), image(n[2]), image(n[1]);
  }
  return sphere;
}

}  // namespace pellucida
