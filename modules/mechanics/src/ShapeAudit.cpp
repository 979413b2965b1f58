#include "pellucida/mechanics/ShapeAudit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pellucida/core/NearestOnContour.h"

namespace pellucida {
namespace {

/// Nodes nearer to the image plane than this share of the radius lie in it.
constexpr double kInPlane_ratio = 1e-6;
/// The rest angle from the contact point that a dimple covers.
constexpr double kDimple_rad = 0.35;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Where one contour sees the model's middle line at `node`, along `normal`; none where it doesn't.
double seen_offset(const std::optional<MembraneContour>& contour, const Eigen::Vector2d& node,
                   const Eigen::Vector2d& normal, double half_thickness_um) {
  // From the face's own place, so that the other side of a fold isn't taken for this one.
  return contour ? offset_of(*contour, node + half_thickness_um * normal, normal) : kNone;
}

}  // namespace

void ShapeAuditor::set_model(const TriangleMesh& rest) {
  nodes_.clear();
  angle_rad_.clear();
  const double radius_um = rest.points_um.colwise().norm().maxCoeff();
  for (Eigen::Index n = 0; n < rest.points_um.cols(); ++n) {
    if (std::abs(rest.points_um(1, n)) < kInPlane_ratio * radius_um) nodes_.push_back(static_cast<int>(n));
  }
  const auto angle = [&](int n) { return std::atan2(rest.points_um(0, n), rest.points_um(2, n)); };
  std::sort(nodes_.begin(), nodes_.end(), [&](int a, int b) { return angle(a) < angle(b); });
  for (const int n : nodes_) angle_rad_.push_back(angle(n));

  // The partner on the other side of the contact point's axis.
  mirror_.resize(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    std::size_t best = k;
    for (std::size_t j = 0; j < nodes_.size(); ++j) {
      const auto off = [&](std::size_t i) {
        return std::abs(std::remainder(angle_rad_[i] + angle_rad_[k], 2.0 * std::numbers::pi));
      };
      if (off(j) < off(best)) best = j;
    }
    mirror_[k] = static_cast<int>(best);
  }
}

ShapeAudit ShapeAuditor::audit(const Observation& observation, const Eigen::Matrix3Xd& x_um,
                               const Eigen::Matrix3d& rotation_WC, const Eigen::Vector3d& center_um,
                               double thickness_um) {
  ShapeAudit result;
  const std::size_t count = nodes_.size();
  residual_um_.assign(count, kNone);
  if (count < 8 || !observation.outer) return result;

  // The model's section in the image, and its outward normals. Rest angles rise from z towards x.
  section_um_.resize(count);
  normal_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    section_um_[k] = (rotation_WC * x_um.col(nodes_[k]) + center_um).head<2>();
  }
  const Eigen::Vector2d right = rotation_WC.col(0).head<2>(), up = rotation_WC.col(2).head<2>();
  const double turn = right.x() * up.y() - right.y() * up.x() > 0.0 ? 1.0 : -1.0;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector2d tangent = section_um_[(k + 1) % count] - section_um_[(k + count - 1) % count];
    normal_[k] = turn * Eigen::Vector2d(-tangent.y(), tangent.x()).normalized();
  }

  // The middle of the two contours, or the one with half the thickness.
  double squares = 0.0, length_um = 0.0, odd_squares = 0.0, odd_length_um = 0.0, dimple = 0.0, dimple_length_um = 0.0;
  std::size_t seen = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double outer = seen_offset(observation.outer, section_um_[k], normal_[k], 0.5 * thickness_um);
    const double inner = seen_offset(observation.inner, section_um_[k], normal_[k], -0.5 * thickness_um);
    residual_um_[k] = std::isnan(inner) ? outer : std::isnan(outer) ? inner : 0.5 * (outer + inner);
    if (std::isnan(residual_um_[k])) continue;
    ++seen;
    const double share_um = 0.5 * (section_um_[(k + 1) % count] - section_um_[(k + count - 1) % count]).norm();
    squares += share_um * residual_um_[k] * residual_um_[k];
    length_um += share_um;
    if (std::abs(angle_rad_[k]) < kDimple_rad) {
      dimple += share_um * residual_um_[k];
      dimple_length_um += share_um;
    }
  }
  if (2 * seen < count || !(length_um > 0.0)) return result;
  for (std::size_t k = 0; k < count; ++k) {
    const double odd = 0.5 * (residual_um_[k] - residual_um_[static_cast<std::size_t>(mirror_[k])]);
    if (std::isnan(odd)) continue;
    odd_squares += odd * odd;
    odd_length_um += 1.0;
  }
  result.residual_rms_um = std::sqrt(squares / length_um);
  if (dimple_length_um > 0.0) result.dimple_residual_um = dimple / dimple_length_um;
  if (odd_length_um > 0.0) result.unexplained_asymmetry_um = std::sqrt(odd_squares / odd_length_um);
  result.asymmetry_um = asymmetry(observation, rotation_WC, center_um);
  const auto& sigma = observation.outer->sigma_um;
  result.noise_um = sigma.size() > 0 ? std::sqrt(sigma.squaredNorm() / static_cast<double>(sigma.size())) : 0.0;
  return result;
}

double ShapeAuditor::asymmetry(const Observation& observation, const Eigen::Matrix3d& rotation_WC,
                               const Eigen::Vector3d& center_um) const {
  // The line through the contact point along the centre's axis is the mirror: each point of the contour against the
  // contour's point nearest to its mirror image.
  const Eigen::Vector2d center = center_um.head<2>(), axis = rotation_WC.col(2).head<2>();
  const Contour_um& points = observation.outer->points_um;
  double squares = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < points.cols(); i += 4) {
    const Eigen::Vector2d from = points.col(i) - center;
    const Eigen::Vector2d image = center + 2.0 * axis.dot(from) * axis - from;
    const double half = 0.5 * nearest_on(points, image).distance_um;
    squares += half * half;
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : kNone;
}

}  // namespace pellucida
