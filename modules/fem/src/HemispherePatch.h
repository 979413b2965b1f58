#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

namespace pellucida {

/// A Delaunay triangulation of the half y >= 0 of the unit sphere. Its border, the circle y = 0, is fixed; nodes are
/// added inside.
class HemispherePatch {
 public:
  struct Triangle {
    std::array<int, 3> nodes{};       ///< counter-clockwise seen from outside
    std::array<int, 3> neighbours{};  ///< across the edge opposite each node; -1 at the border
  };

  /// `border`: nodes of the unit circle y = 0, in the order +z, +x, -z, -x; at least three.
  explicit HemispherePatch(const std::vector<Eigen::Vector3d>& border);

  const std::vector<Eigen::Vector3d>& points() const noexcept { return points_; }
  const std::vector<Triangle>& triangles() const noexcept { return triangles_; }
  int border_count() const noexcept { return border_count_; }

  /// Adds a node in the middle of a triangle. Appends the triangles it changed to `changed`.
  void split(int triangle, std::vector<int>& changed);

  /// Moves the inner nodes to `points` (as many as there are), then flips edges until the triangulation is Delaunay.
  void move_inner(const std::vector<Eigen::Vector3d>& points);

 private:
  bool should_flip(int triangle, int corner, int& other, int& other_corner) const;
  void flip(int triangle, int corner, int other, int other_corner);
  void legalize(std::vector<int> pending, std::vector<int>& changed);

  int border_count_ = 0;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Triangle> triangles_;
};

}  // namespace pellucida
