#include "AxisymmetricMesh.h"

#include <cmath>
#include <numbers>

namespace pellucida {

std::array<double, 3> quadratic(double xi) {
  return {0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)};
}

std::array<double, 3> quadratic_slope(double xi) {
  return {xi - 0.5, -2.0 * xi, xi + 0.5};
}

AxisymmetricMesh make_axisymmetric_mesh(double mid_radius_um, double thickness_um,
                                        const std::function<double(double)>& edge_length_um, int across,
                                        double aspect_ratio) {
  // Corners along the meridian: as many as 1 / length, integrated, says.
  constexpr int kSteps = 20000;
  std::vector<double> cumulative(kSteps + 1, 0.0);
  for (int k = 0; k < kSteps; ++k) {
    cumulative[static_cast<std::size_t>(k) + 1] =
        cumulative[static_cast<std::size_t>(k)] +
        std::numbers::pi * mid_radius_um / kSteps / edge_length_um(std::numbers::pi * (k + 0.5) / kSteps);
  }
  const int along = std::max(4, static_cast<int>(std::lround(cumulative.back())));
  std::vector<double> angles;
  std::size_t cell = 0;
  for (int n = 0; n <= along; ++n) {
    const double target = cumulative.back() * n / along;
    while (cell + 1 < kSteps && cumulative[cell + 1] < target) ++cell;
    const double part = (target - cumulative[cell]) / (cumulative[cell + 1] - cumulative[cell]);
    const double angle = n == along ? std::numbers::pi : std::numbers::pi * (static_cast<double>(cell) + part) / kSteps;
    if (n > 0) angles.push_back(0.5 * (angles.back() + angle));
    angles.push_back(angle);
  }

  // Nodes, column by column.
  AxisymmetricMesh mesh;
  const int rows = 2 * across + 1, columns = 2 * along + 1;
  mesh.points_um.resize(3, rows * columns);
  const auto node = [rows](int column, int row) { return column * rows + row; };
  const double along_um = mid_radius_um * std::sqrt(aspect_ratio), across_um = mid_radius_um / std::sqrt(aspect_ratio);
  for (int i = 0; i < columns; ++i) {
    const double angle = angles[static_cast<std::size_t>(i)];
    const bool pole = i == 0 || i == columns - 1;
    const Eigen::Vector2d on_middle(across_um * std::sin(angle), along_um * std::cos(angle));
    const Eigen::Vector2d normal =
        Eigen::Vector2d(std::sin(angle) / across_um, std::cos(angle) / along_um).normalized();
    for (int j = 0; j < rows; ++j) {
      const Eigen::Vector2d p = on_middle + thickness_um * (static_cast<double>(j) / (rows - 1) - 0.5) * normal;
      mesh.points_um.col(node(i, j)) << (pole ? 0.0 : p.x()), 0.0, p.y();
      if (pole) mesh.axis.push_back(node(i, j));
    }
    mesh.inner.push_back(node(i, 0));
    mesh.middle.push_back(node(i, rows / 2));
    mesh.outer.push_back(node(i, rows - 1));
  }
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < across; ++j) {
      std::array<int, 9> element{};
      for (int b = 0; b < 3; ++b) {
        for (int a = 0; a < 3; ++a) element[static_cast<std::size_t>(3 * b + a)] = node(2 * i + a, 2 * j + b);
      }
      mesh.elements.push_back(element);
    }
  }
  return mesh;
}

}  // namespace pellucida
