#include "pellucida/mechanics/RevolvedContour.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// The section's residual at a rest angle, between its nodes; 0 where it saw nothing.
double residual_at(const ShapeAuditor& section, double angle_rad) {
  const auto& angles = section.rest_angle_rad();
  const auto above = std::upper_bound(angles.begin(), angles.end(), angle_rad);
  const std::size_t count = angles.size();
  const std::size_t next = above == angles.end() ? count - 1 : static_cast<std::size_t>(above - angles.begin());
  const std::size_t before = next > 0 ? next - 1 : 0;
  const double span = angles[next] - angles[before];
  const double t = span > 0.0 ? std::clamp((angle_rad - angles[before]) / span, 0.0, 1.0) : 0.0;
  const double value = (1.0 - t) * section.residual_um()[before] + t * section.residual_um()[next];
  return std::isfinite(value) ? value : 0.0;
}

}  // namespace

void revolve_residual(const TriangleMesh& rest, const Eigen::Matrix3Xd& x_um, const ShapeAuditor& section,
                      Eigen::VectorXd& residual_um, Eigen::Matrix3Xd& normal) {
  const Eigen::Index count = x_um.cols();
  residual_um.setZero(count);
  normal.setZero(3, count);
  for (Eigen::Index t = 0; t < rest.triangles.cols(); ++t) {
    const Eigen::Vector3i nodes = rest.triangles.col(t);
    const Eigen::Vector3d a = x_um.col(nodes[0]), b = x_um.col(nodes[1]), c = x_um.col(nodes[2]);
    const Eigen::Vector3d area = (b - a).cross(c - a);
    for (const int node : nodes) normal.col(node) += area;
  }
  for (Eigen::Index n = 0; n < count; ++n) {
    const double length = normal.col(n).norm();
    normal.col(n) = length > 0.0 ? Eigen::Vector3d(normal.col(n) / length) : Eigen::Vector3d::UnitZ();
    if (section.nodes().empty()) continue;
    const Eigen::Vector3d p = rest.points_um.col(n);
    const double across = std::hypot(p.x(), p.y());
    const double angle_rad = std::atan2(across, p.z());
    const double right = across > 0.0 ? 0.5 + 0.5 * p.x() / across : 0.5;
    residual_um[n] = right * residual_at(section, angle_rad) + (1.0 - right) * residual_at(section, -angle_rad);
  }
}

std::vector<NormalObservationTerm::Observed> observe_revolved(const TriangleMesh& rest, const Eigen::Matrix3Xd& x_um,
                                                              const ShapeAuditor& section, double weight_uN_per_um3) {
  Eigen::VectorXd residual_um;
  Eigen::Matrix3Xd normal;
  revolve_residual(rest, x_um, section, residual_um, normal);
  const Eigen::VectorXd areas_um2 = node_areas_um2(rest.points_um, rest.triangles);
  std::vector<NormalObservationTerm::Observed> observed;
  observed.reserve(static_cast<std::size_t>(x_um.cols()));
  for (Eigen::Index n = 0; n < x_um.cols(); ++n) {
    const Eigen::Vector3d direction = normal.col(n);
    observed.push_back(
        {static_cast<int>(n), x_um.col(n) + residual_um[n] * direction, direction, areas_um2[n], weight_uN_per_um3});
  }
  return observed;
}

Eigen::Matrix3Xd lay_on_contour(const TriangleMesh& rest, const Eigen::Matrix3Xd& x_um, const ShapeAuditor& section) {
  Eigen::VectorXd residual_um;
  Eigen::Matrix3Xd normal;
  revolve_residual(rest, x_um, section, residual_um, normal);
  return x_um + normal * residual_um.asDiagonal();
}

double naive_force_uN(const MembraneModel& model, const Eigen::Matrix3Xd& laid_um) {
  const Eigen::Matrix3Xd elastic_uN = model.elastic_force_uN(laid_um);
  double force_uN = 0.0;
  for (const int node : model.tip().nodes()) force_uN -= model.setup().push.dot(elastic_uN.col(node));
  return force_uN;
}

}  // namespace pellucida
