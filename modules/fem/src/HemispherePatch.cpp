#include "HemispherePatch.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace pellucida {
namespace {

/// Differences of the convexity determinant below this are rounding: four nodes on one circle stay as they are.
constexpr double kRounding = 1e-13;

/// Six times the volume of the tetrahedron; positive when d lies outside the plane of (a, b, c), i.e. in the circle.
double volume6(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  return (b - a).cross(c - a).dot(d - a);
}

}  // namespace

HemispherePatch::HemispherePatch(const std::vector<Eigen::Vector3d>& border)
    : border_count_(static_cast<int>(border.size())), points_(border) {
  // A fan about the pole, then flipped to Delaunay.
  const int pole = border_count_;
  points_.push_back(Eigen::Vector3d::UnitY());
  std::vector<int> all;
  for (int k = 0; k < border_count_; ++k) {
    const int next = (k + 1) % border_count_, previous = (k + border_count_ - 1) % border_count_;
    triangles_.push_back({{k, next, pole}, {next, previous, -1}});
    all.push_back(k);
  }
  std::vector<int> changed;
  legalize(all, changed);
}

void HemispherePatch::split(int triangle, std::vector<int>& changed) {
  // (a, b, c) becomes (a, b, p), (b, c, p), (c, a, p).
  const Triangle old = triangles_[static_cast<std::size_t>(triangle)];
  const int p = static_cast<int>(points_.size());
  points_.push_back((points_[static_cast<std::size_t>(old.nodes[0])] + points_[static_cast<std::size_t>(old.nodes[1])] +
                     points_[static_cast<std::size_t>(old.nodes[2])])
                        .normalized());
  const int second = static_cast<int>(triangles_.size()), third = second + 1;
  const std::array<int, 3> place{triangle, second, third};
  triangles_.resize(triangles_.size() + 2);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    const int outer = old.neighbours[static_cast<std::size_t>(previous)];
    triangles_[static_cast<std::size_t>(place[k])] = {
        {old.nodes[static_cast<std::size_t>(k)], old.nodes[static_cast<std::size_t>(next)], p},
        {place[static_cast<std::size_t>(next)], place[static_cast<std::size_t>(previous)], outer}};
    if (outer >= 0) {
      for (int& back : triangles_[static_cast<std::size_t>(outer)].neighbours) {
        // Each outer triangle meets the old one across one edge only, but may be met twice by a fan: match the edge.
        if (back != triangle) continue;
        const auto corner =
            static_cast<std::size_t>(&back - triangles_[static_cast<std::size_t>(outer)].neighbours.data());
        if (triangles_[static_cast<std::size_t>(outer)].nodes[(corner + 1) % 3] ==
            old.nodes[static_cast<std::size_t>(next)]) {
          back = place[static_cast<std::size_t>(k)];
          break;
        }
      }
    }
  }
  legalize({triangle, second, third}, changed);
}

bool HemispherePatch::should_flip(int triangle, int corner, int& other, int& other_corner) const {
  const Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
  other = t.neighbours[static_cast<std::size_t>(corner)];
  if (other < 0) return false;
  const Triangle& o = triangles_[static_cast<std::size_t>(other)];
  const int from = t.nodes[static_cast<std::size_t>((corner + 1) % 3)];
  for (other_corner = 0; other_corner < 3; ++other_corner) {
    const auto c = static_cast<std::size_t>(other_corner);
    if (o.neighbours[c] == triangle && o.nodes[(c + 2) % 3] == from) break;
  }
  const auto point = [&](const Triangle& of, int at) -> const Eigen::Vector3d& {
    return points_[static_cast<std::size_t>(of.nodes[static_cast<std::size_t>(at % 3)])];
  };
  return volume6(point(t, 0), point(t, 1), point(t, 2), point(o, other_corner)) > kRounding;
}

void HemispherePatch::flip(int triangle, int corner, int other, int other_corner) {
  Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
  Triangle& o = triangles_[static_cast<std::size_t>(other)];
  const auto at = [](const std::array<int, 3>& values, int k) { return values[static_cast<std::size_t>(k % 3)]; };
  const int c = at(t.nodes, corner), a = at(t.nodes, corner + 1), b = at(t.nodes, corner + 2);
  const int d = at(o.nodes, other_corner);
  const int across_bc = at(t.neighbours, corner + 1), across_ca = at(t.neighbours, corner + 2);
  // The other triangle is (d, b, a).
  const int across_ad = at(o.neighbours, other_corner + 1), across_db = at(o.neighbours, other_corner + 2);
  t = {{c, a, d}, {across_ad, other, across_ca}};
  o = {{d, b, c}, {across_bc, triangle, across_db}};

  // The two neighbours that changed hands.
  const auto hand_over = [&](int neighbour, int from, int to, int edge_end) {
    if (neighbour < 0) return;
    Triangle& n = triangles_[static_cast<std::size_t>(neighbour)];
    for (std::size_t k = 0; k < 3; ++k) {
      if (n.neighbours[k] == from && n.nodes[(k + 2) % 3] == edge_end) n.neighbours[k] = to;
    }
  };
  hand_over(across_ad, other, triangle, a);
  hand_over(across_bc, triangle, other, b);
}

void HemispherePatch::legalize(std::vector<int> pending, std::vector<int>& changed) {
  changed.insert(changed.end(), pending.begin(), pending.end());
  while (!pending.empty()) {
    const int triangle = pending.back();
    pending.pop_back();
    for (int corner = 0; corner < 3; ++corner) {
      int other = -1, other_corner = -1;
      if (!should_flip(triangle, corner, other, other_corner)) continue;
      flip(triangle, corner, other, other_corner);
      for (const int touched : {other, triangle}) {
        pending.push_back(touched);
        changed.push_back(touched);
      }
      break;
    }
  }
}

void HemispherePatch::move_inner(const std::vector<Eigen::Vector3d>& points) {
  std::copy(points.begin(), points.end(), points_.begin() + border_count_);
  std::vector<int> all(triangles_.size()), changed;
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<int>(k);
  legalize(all, changed);
}

}  // namespace pellucida
