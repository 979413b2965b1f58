#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace pellucida {

/// The meridian half-section of a shell, spherical or spheroidal, in nine-node quadrilaterals, from the tip's pole (+z)
/// to the holder's (-z) and from the inner surface to the outer. Nodes carry (r, 0, z).
struct AxisymmetricMesh {
  Eigen::Matrix3Xd points_um;  ///< (3 x n)
  /// Nodes of each element, row by row from the inner surface out, each row along the meridian from the tip: with xi
  /// along and eta across, in -1, 0, 1 each, node 3 * (eta + 1) + (xi + 1).
  std::vector<std::array<int, 9>> elements;
  std::vector<int> inner, middle, outer;  ///< nodes of the surfaces, from the tip's pole to the holder's
  std::vector<int> axis;                  ///< nodes on the axis
};

/// `edge_length_um(angle from +z)` is the length asked for of an element's side along the middle surface; `across`
/// elements through the thickness, an even number unless 1 (so that the middle surface has nodes either way). The
/// middle surface is a spheroid about the axis, its semi-axes `mid_radius_um` times and over the square root of
/// `aspect_ratio`, and angles are eccentric ones.
AxisymmetricMesh make_axisymmetric_mesh(double mid_radius_um, double thickness_um,
                                        const std::function<double(double angle_rad)>& edge_length_um, int across,
                                        double aspect_ratio = 1.0);

/// The three-point Gauss rule on [-1, 1], and the quadratic Lagrange functions of -1, 0, 1 with their slopes.
constexpr std::array<double, 3> kGaussPlace{-0.7745966692414834, 0.0, 0.7745966692414834};
constexpr std::array<double, 3> kGaussWeight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
std::array<double, 3> quadratic(double xi);
std::array<double, 3> quadratic_slope(double xi);

}  // namespace pellucida
