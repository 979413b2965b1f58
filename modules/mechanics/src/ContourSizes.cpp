#include "ContourSizes.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "NearestOnContour.h"

namespace pellucida {
namespace {

/// Every second node of the solid's section from this angle to that one, rad: nearer to the needle a contour may cut
/// across the dimple, and under the holding pipette none is seen.
constexpr double kFrom_rad = 0.27, kTo_rad = 2.6;
constexpr Eigen::Index kNodeStep = 2;
/// No node so near to where a tool touches, rad.
constexpr double kBesideTool_rad = 0.1;
/// Depths at which a contour counts, and how near to one it has to be, over the outer radius.
constexpr double kDepthStep_ratio = 0.08, kDepthWindow_ratio = 0.02;
/// An outline at rest is the mean of so many frames at least, and at most.
constexpr int kFewestRest = 3, kMostRest = 30;
/// How far a cell differs from the solid, of the outer radius: at no depth, and more by the depth; correlated over such
/// an angle, and over such a depth. Set on GetFEM specimens out of round, sucked and stiffening (docs/method.md, 4.4),
/// twice what they leave, since their walls move the estimate more than independent differences would.
constexpr double kModel_ratio = 0.004, kModelByDepth_ratio = 0.04, kModel_rad = 0.5, kModelDepth_ratio = 0.5;
/// How far a contour is from its edge, um: in the same way at all depths, over a shorter angle; and from frame to
/// frame.
constexpr double kEdge_um = 0.2, kEdge_rad = 0.2, kNoise_um = 0.1;
/// Of the cell's place along the needle, of its radius, and of a frame's depth, um.
constexpr double kPlace_um = 0.3, kRadius_um = 0.2, kDepth_um = 0.2;
/// Gauss-Newton: steps, the longest and the last, in logarithms; and for derivatives.
constexpr int kMostSteps = 6;
constexpr double kLongestStep = 0.4, kLastStep = 0.01, kDifference = 0.05, kDepthDifference_ratio = 0.01;
/// Fewer nodes say nothing.
constexpr Eigen::Index kFewestNodes = 8;
/// A size that the picture shows to within this (ln) stays as it is: its edges say more of it than the contours of a
/// cell that is never just the solid.
constexpr double kOpen_log = 0.2;
/// Contours that differ from every solid by more than this, squared, over what is expected, show something else.
constexpr double kLargestMisfit = 2.0;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double kernel(double difference, double width) {
  const double z = difference / width;
  return std::exp(-0.5 * z * z);
}

bool is_open(const SizesPrior& prior, int size) {
  return prior.sigma[size] > kOpen_log;
}

/// Outward normals of a half-section.
Eigen::Matrix2Xd normals_of(const Eigen::Matrix2Xd& section) {
  const Eigen::Index n = section.cols();
  Eigen::Matrix2Xd normals(2, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Vector2d along = section.col(std::min(k + 1, n - 1)) - section.col(std::max<Eigen::Index>(k - 1, 0));
    normals.col(k) = Eigen::Vector2d(-along.y(), along.x()).normalized();
  }
  return normals;
}

}  // namespace

/// One row for each node that a contour shows.
struct ContourSizes::Misfit {
  Eigen::VectorXd residual_um;  // contour less solid, along the normal
  Eigen::MatrixX3d slope_um;    // of the solid, by the logarithms of the sizes
  Eigen::VectorXd angle_rad, depth_ratio, normal_z, depth_slope;
};

MembraneContour ContourSizes::in_cell(const Observation& o, const CellPlacement& placement) {
  MembraneContour contour = *o.outer;
  const Eigen::Matrix3d& R = placement.rotation_WC();
  Eigen::Matrix2d to_cell;
  to_cell.row(0) = R.col(0).head<2>().transpose();
  to_cell.row(1) = R.col(2).head<2>().transpose();
  contour.points_um = to_cell * (o.outer->points_um.colwise() - o.center_um);
  return contour;
}

// Both halves of a contour against a half-section, their mean.
Eigen::VectorXd ContourSizes::offsets(const MembraneContour& contour, const Eigen::Matrix2Xd& places,
                                      const Eigen::Matrix2Xd& normals) const {
  Eigen::VectorXd mean = Eigen::VectorXd::Constant(places.cols(), kNone);
  for (Eigen::Index k = 0; k < places.cols(); k += kNodeStep) {
    if (solid_.angle_rad()[k] < kFrom_rad || solid_.angle_rad()[k] > kTo_rad) continue;
    const Eigen::Vector2d place = places.col(k), normal = normals.col(k);
    const double right = offset_of(contour, place, normal);
    const double left = offset_of(contour, {-place.x(), place.y()}, {-normal.x(), normal.y()});
    mean[k] = std::isnan(right) ? left : std::isnan(left) ? right : 0.5 * (left + right);
  }
  return mean;
}

void ContourSizes::add_rest(const Observation& o, const CellPlacement& placement) {
  if (!o.outer || !(o.rest_outer_radius_um > 0.0)) return;
  const auto& angle = solid_.angle_rad();
  Eigen::Matrix2Xd circle(2, angle.size());
  circle.row(0) = angle.array().sin().matrix().transpose();
  circle.row(1) = angle.array().cos().matrix().transpose();
  const Eigen::VectorXd seen = offsets(in_cell(o, placement), o.rest_outer_radius_um * circle, circle);
  if (!seen.array().isFinite().any()) return;
  if (rest_count_ == 0) rest_ = Eigen::VectorXd::Zero(angle.size());
  rest_count_ = std::min(rest_count_ + 1, kMostRest);
  for (Eigen::Index k = 0; k < seen.size(); ++k)
    if (!std::isnan(seen[k])) rest_[k] += (seen[k] - rest_[k]) / rest_count_;
}

bool ContourSizes::add(const Observation& o, const CellPlacement& placement, double depth_um) {
  if (!o.outer || !(o.rest_outer_radius_um > 0.0) || rest_count_ < kFewestRest) return false;
  if (contours_.empty()) radius_um_ = o.rest_outer_radius_um;
  const double depth_ratio = depth_um / radius_um_, place = std::round(depth_ratio / kDepthStep_ratio);
  const bool counts = place >= 1.0 && depth_ratio <= solid_.deepest_ratio() &&
                      std::abs(depth_ratio - place * kDepthStep_ratio) < kDepthWindow_ratio;
  if (!counts) return false;
  const auto at = std::find_if(contours_.begin(), contours_.end(), [&](const Seen& seen) {
    return std::round(seen.depth_ratio / kDepthStep_ratio) >= place;
  });
  if (at != contours_.end() && std::round(at->depth_ratio / kDepthStep_ratio) == place) return false;
  contours_.insert(at, {depth_ratio, in_cell(o, placement)});
  return true;
}

ContourSizes::Misfit ContourSizes::misfit(const LogSizes& sizes) const {
  const double from_rad = std::asin(std::min(1.0, std::exp(sizes[1]))) + kBesideTool_rad;
  const double to_rad = std::numbers::pi - std::asin(std::min(1.0, std::exp(sizes[2]))) - kBesideTool_rad;
  const auto nodes = solid_.angle_rad().size();
  const auto most = static_cast<Eigen::Index>(contours_.size()) * (nodes / kNodeStep + 1);
  Misfit all{Eigen::VectorXd(most), Eigen::MatrixX3d(most, 3), Eigen::VectorXd(most),
             Eigen::VectorXd(most), Eigen::VectorXd(most),     Eigen::VectorXd(most)};
  Eigen::Index row = 0;
  for (const Seen& seen : contours_) {
    const Eigen::Matrix2Xd section = solid_.section(sizes, seen.depth_ratio), normals = normals_of(section);
    const Eigen::VectorXd offset = offsets(seen.contour, radius_um_ * section, normals) - rest_;
    const Eigen::Matrix2Xd deeper = solid_.section(sizes, seen.depth_ratio + kDepthDifference_ratio) - section;
    Eigen::Matrix2Xd changed[3];
    for (int size = 0; size < 3; ++size) {
      changed[size] = solid_.section(sizes + kDifference * LogSizes::Unit(size), seen.depth_ratio) -
                      solid_.section(sizes - kDifference * LogSizes::Unit(size), seen.depth_ratio);
    }
    for (Eigen::Index k = 0; k < nodes; k += kNodeStep) {
      const double angle = solid_.angle_rad()[k];
      if (std::isnan(offset[k]) || angle < from_rad || angle > to_rad) continue;
      all.residual_um[row] = offset[k];
      for (int size = 0; size < 3; ++size)
        all.slope_um(row, size) = radius_um_ * normals.col(k).dot(changed[size].col(k)) / (2.0 * kDifference);
      all.angle_rad[row] = angle;
      all.depth_ratio[row] = seen.depth_ratio;
      all.normal_z[row] = normals(1, k);
      all.depth_slope[row] = normals.col(k).dot(deeper.col(k)) / kDepthDifference_ratio;
      ++row;
    }
  }
  all.residual_um.conservativeResize(row);
  all.slope_um.conservativeResize(row, 3);
  for (Eigen::VectorXd* column : {&all.angle_rad, &all.depth_ratio, &all.normal_z, &all.depth_slope})
    column->conservativeResize(row);
  return all;
}

// What cell and solid differ by, and what isn't known of contour, place, radius and depth. The lower triangle.
Eigen::MatrixXd ContourSizes::covariance_um2(const Misfit& seen) const {
  const Eigen::Index n = seen.residual_um.size();
  const Eigen::VectorXd model_um = radius_um_ * (kModel_ratio + kModelByDepth_ratio * seen.depth_ratio.array());
  Eigen::MatrixXd covariance(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = j; i < n; ++i) {
      const double turn_rad = seen.angle_rad[i] - seen.angle_rad[j];
      const double deeper = seen.depth_ratio[i] - seen.depth_ratio[j];
      double& sum = covariance(i, j);
      sum = model_um[i] * model_um[j] * kernel(turn_rad, kModel_rad) * kernel(deeper, kModelDepth_ratio);
      sum += kEdge_um * kEdge_um * kernel(turn_rad, kEdge_rad);
      sum += kPlace_um * kPlace_um * seen.normal_z[i] * seen.normal_z[j];
      sum += kRadius_um * kRadius_um;
      if (deeper == 0.0) sum += kDepth_um * kDepth_um * seen.depth_slope[i] * seen.depth_slope[j];
      if (i == j) sum += kNoise_um * kNoise_um;
    }
  }
  return covariance;
}

std::optional<ContourSizes::Sizes> ContourSizes::estimate(const SizesPrior& prior) {
  const bool has_open = is_open(prior, 0) || is_open(prior, 1) || is_open(prior, 2);
  if (contours_.empty() || !has_open) return std::nullopt;
  const Eigen::Matrix3d weight = prior.sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  LogSizes sizes = solid_.within_range(start_.value_or(prior.mean));
  for (int step = 0; step < kMostSteps; ++step) {
    const Misfit seen = misfit(sizes);
    const Eigen::Index n = seen.residual_um.size();
    if (n < kFewestNodes) return std::nullopt;
    const Eigen::LLT<Eigen::MatrixXd, Eigen::Lower> factor(covariance_um2(seen));
    const Eigen::MatrixX3d weighed = factor.solve(seen.slope_um);
    const Eigen::VectorXd explained = factor.solve(seen.residual_um);
    const Eigen::Matrix3d information = weight + seen.slope_um.transpose() * weighed;
    const LogSizes gradient = weighed.transpose() * seen.residual_um - weight * (sizes - prior.mean);
    const LogSizes change = information.ldlt().solve(gradient).cwiseMax(-kLongestStep).cwiseMin(kLongestStep);
    const LogSizes next = solid_.within_range(sizes + change);
    const double moved = (next - sizes).cwiseAbs().maxCoeff();
    if (moved < kLastStep || step + 1 == kMostSteps) {
      if (seen.residual_um.dot(explained) > kLargestMisfit * static_cast<double>(n)) return std::nullopt;
      start_ = next;
      Sizes result{next, information.inverse()};
      for (int size = 0; size < 3; ++size) {
        if (is_open(prior, size)) continue;
        result.mean[size] = prior.mean[size];
        result.covariance.row(size).setZero();
        result.covariance.col(size).setZero();
        result.covariance(size, size) = prior.sigma[size] * prior.sigma[size];
      }
      return result;
    }
    sizes = next;
  }
  return std::nullopt;
}

ContourSizes::ForceChange ContourSizes::force_change(const LogSizes& from, const LogSizes& to,
                                                     double depth_ratio) const {
  ForceChange change;
  change.log_ratio = solid_.log_force(to, depth_ratio) - solid_.log_force(from, depth_ratio);
  change.log_pressure_ratio = solid_.log_pressure(to, depth_ratio) - solid_.log_pressure(from, depth_ratio);
  for (int size = 0; size < 3; ++size) {
    const LogSizes step = kDifference * LogSizes::Unit(size);
    change.slope[size] =
        (solid_.log_force(to + step, depth_ratio) - solid_.log_force(to - step, depth_ratio)) / (2.0 * kDifference);
  }
  return change;
}

}  // namespace pellucida
