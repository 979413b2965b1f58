#include "ContourSizes.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "pellucida/core/NearestOnContour.h"

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
/// where the stiffening is wrong by 0.7 of its standard deviation.
constexpr double kModel_ratio = 0.004, kModelByDepth_ratio = 0.03, kModel_rad = 0.5, kModelDepth_ratio = 0.5;
/// How far a contour is from its edge, um: in the same way at all depths, over a shorter angle; and from frame to
/// frame. A contour that says of itself that it is farther off is so in a way of its own, over that angle too.
constexpr double kEdge_um = 0.2, kEdge_rad = 0.2, kNoise_um = 0.1;
/// Of the cell's place along the needle, of its radius, and of a frame's depth, um.
constexpr double kPlace_um = 0.3, kRadius_um = 0.2, kDepth_um = 0.2;
/// Of an outline's ln of length over width.
constexpr double kElongation_sigma = 0.01;
/// Gauss-Newton: steps, the longest and the last, in logarithms. Of a contour the solid's shape and slope are taken
/// where it was last held against the solid, unless that was farther away than this.
constexpr int kMostSteps = 30;
constexpr double kLongestStep = 0.4, kLastStep = 0.01, kFarthestSlope = 0.03;
constexpr int kContoursPerStep = 2;
/// Fewer nodes say nothing.
constexpr Eigen::Index kFewestNodes = 8;
/// Nor do fewer say how long the cell is, of 17.
constexpr std::size_t kFewestForElongation = 12;
/// Contours that differ from every solid by more than this, squared, over what is expected, show something else.
constexpr double kLargestMisfit = 2.0;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double kernel(double difference, double width) {
  const double z = difference / width;
  return std::exp(-0.5 * z * z);
}

// A size that the picture shows well: its edges say more of it than the contours of a cell that is never just the
// solid.
bool is_open(const ParametersPrior& prior, int parameter) {
  return prior.sigma[parameter] > ContourSizes::kOpen;
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

using Information = Eigen::Matrix<double, kParameters, kParameters>;

// Newton's step. No wall softens with strain: where that is what the contours would say, the others are looked for
// with a wall that doesn't stiffen.
SolidParameters step_within(const Information& information, const SolidParameters& gradient,
                            const SolidParameters& at) {
  SolidParameters step = information.ldlt().solve(gradient);
  if (at[kStiffening] + step[kStiffening] < 0.0) {
    Information held = information;
    held.row(kStiffening).setZero();
    held.col(kStiffening).setZero();
    held(kStiffening, kStiffening) = 1.0;
    SolidParameters left = gradient + at[kStiffening] * information.col(kStiffening);
    left[kStiffening] = -at[kStiffening];
    step = held.ldlt().solve(left);
  }
  return step.cwiseMax(-kLongestStep).cwiseMin(kLongestStep);
}

}  // namespace

void ContourSizes::Misfit::resize(Eigen::Index rows) {
  residual_um.conservativeResize(rows);
  slope_um.conservativeResize(rows, kParameters);
  for (Eigen::VectorXd* column : {&depth_ratio, &normal_z, &depth_slope, &edge_um, &depth_um})
    column->conservativeResize(rows);
  node.resize(static_cast<std::size_t>(rows));
}

void ContourSizes::clear() noexcept {
  contours_.clear();
  at_.reset();
  estimate_.reset();
  is_settled_ = true;
}

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
  radius_um_ = o.rest_outer_radius_um;
  if (rest_count_ == 0) rest_ = Eigen::VectorXd::Constant(angle.size(), kNone);
  rest_count_ = std::min(rest_count_ + 1, kMostRest);
  for (Eigen::Index k = 0; k < seen.size(); ++k)
    if (!std::isnan(seen[k])) rest_[k] = std::isnan(rest_[k]) ? seen[k] : rest_[k] + (seen[k] - rest_[k]) / rest_count_;
  if (rest_count_ >= kFewestRest) elongation_ = elongation_of_rest();
  for (Seen& contour : contours_) contour.at.reset();
}

// By least squares over what was seen: a circle of another size, moved along the needle, and an ellipse.
double ContourSizes::elongation_of_rest() const {
  std::vector<Eigen::Index> seen;
  for (Eigen::Index k = 0; k < rest_.size(); k += kNodeStep)
    if (!std::isnan(rest_[k])) seen.push_back(k);
  if (seen.size() < kFewestForElongation) return 0.0;
  const auto angle = solid_.angle_rad()(seen).array();
  Eigen::MatrixX3d harmonics(static_cast<Eigen::Index>(seen.size()), 3);
  harmonics << Eigen::VectorXd::Ones(harmonics.rows()), angle.cos(), (2.0 * angle).cos();
  const Eigen::Vector3d amplitude_um = harmonics.colPivHouseholderQr().solve(rest_(seen));
  return 2.0 * amplitude_um[2] / radius_um_;
}

void ContourSizes::add(const Observation& o, const CellPlacement& placement, double depth_um, double depth_sigma_um) {
  if (!o.outer || !(o.rest_outer_radius_um > 0.0) || rest_count_ < kFewestRest) return;
  const double depth_ratio = depth_um / radius_um_, place = std::round(depth_ratio / kDepthStep_ratio);
  const bool counts = place >= 1.0 && depth_ratio <= solid_.deepest_ratio() &&
                      std::abs(depth_ratio - place * kDepthStep_ratio) < kDepthWindow_ratio;
  if (!counts) return;
  const auto at = std::find_if(contours_.begin(), contours_.end(), [&](const Seen& seen) {
    return std::round(seen.depth_ratio / kDepthStep_ratio) >= place;
  });
  if (at != contours_.end() && std::round(at->depth_ratio / kDepthStep_ratio) == place) return;
  contours_.insert(at, {.depth_ratio = depth_ratio,
                        .contour = in_cell(o, placement),
                        .edge_um = usual_sigma_um(*o.outer),
                        .depth_um = depth_sigma_um,
                        .at = {},
                        .misfit = {}});
  steps_ = 0;
  is_settled_ = false;
}

// A contour against the solid of the parameters it is to be held against.
ContourSizes::Misfit ContourSizes::misfit(const Seen& seen) const {
  const SolidParameters& parameters = *seen.at;
  const double from_rad = std::asin(std::min(1.0, std::exp(parameters[1]))) + kBesideTool_rad;
  const double to_rad = std::numbers::pi - std::asin(std::min(1.0, std::exp(parameters[2]))) - kBesideTool_rad;
  const auto nodes = solid_.angle_rad().size();
  // The outline at rest, from its ellipse.
  const Eigen::VectorXd rest_um =
      rest_.array() - 0.5 * radius_um_ * elongation_ * (2.0 * solid_.angle_rad().array()).cos();
  const auto section = solid_.section(parameters, seen.depth_ratio);
  const Eigen::Matrix2Xd normals = normals_of(section.places);
  const Eigen::VectorXd offset = offsets(seen.contour, radius_um_ * section.places, normals) - rest_um;
  Misfit misfit;
  misfit.resize(nodes / kNodeStep + 1);
  Eigen::Index row = 0;
  for (Eigen::Index k = 0; k < nodes; k += kNodeStep) {
    const double angle = solid_.angle_rad()[k];
    if (std::isnan(offset[k]) || angle < from_rad || angle > to_rad) continue;
    misfit.residual_um[row] = offset[k];
    for (int p = 0; p < kParameters; ++p)
      misfit.slope_um(row, p) =
          p == kElongation ? 0.0
                           : radius_um_ * normals.col(k).dot(section.by_parameter[static_cast<std::size_t>(p)].col(k));
    misfit.node[static_cast<std::size_t>(row)] = static_cast<int>(k / kNodeStep);
    misfit.depth_ratio[row] = seen.depth_ratio;
    misfit.normal_z[row] = normals(1, k);
    misfit.depth_slope[row] = normals.col(k).dot(section.by_depth.col(k));
    misfit.edge_um[row] = seen.edge_um;
    misfit.depth_um[row] = seen.depth_um;
    ++row;
  }
  misfit.resize(row);
  return misfit;
}

// Some of the contours whose solid is too far from the present one, farthest first. False: all are near by now.
bool ContourSizes::hold_against_solid() {
  int held = 0;
  for (; held < kContoursPerStep; ++held) {
    const auto distance = [this](const Seen& seen) {
      return seen.at ? (*at_ - *seen.at).cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity();
    };
    const auto farthest = std::max_element(contours_.begin(), contours_.end(),
                                           [&](const Seen& a, const Seen& b) { return distance(a) < distance(b); });
    if (distance(*farthest) < kFarthestSlope) break;
    farthest->at = at_;
    farthest->misfit = misfit(*farthest);
  }
  return held > 0;
}

// Against the solid of the present parameters, as slopes have it.
ContourSizes::Misfit ContourSizes::misfit_of_all() const {
  Misfit all;
  Eigen::Index rows = 0;
  for (const Seen& seen : contours_) rows += seen.misfit.residual_um.size();
  all.resize(rows);
  Eigen::Index row = 0;
  for (const Seen& seen : contours_) {
    const Misfit& one = seen.misfit;
    const Eigen::Index n = one.residual_um.size();
    all.residual_um.segment(row, n) = one.residual_um - one.slope_um * (*at_ - *seen.at);
    all.slope_um.middleRows(row, n) = one.slope_um;
    all.depth_ratio.segment(row, n) = one.depth_ratio;
    all.normal_z.segment(row, n) = one.normal_z;
    all.depth_slope.segment(row, n) = one.depth_slope;
    all.edge_um.segment(row, n) = one.edge_um;
    all.depth_um.segment(row, n) = one.depth_um;
    std::copy(one.node.begin(), one.node.end(), all.node.begin() + row);
    row += n;
  }
  return all;
}

// What cell and solid differ by, and what isn't known of contour, place, radius and depth. The lower triangle.
Eigen::MatrixXd ContourSizes::covariance_um2(const Misfit& seen) const {
  const Eigen::Index n = seen.residual_um.size();
  const Eigen::VectorXd model_um = radius_um_ * (kModel_ratio + kModelByDepth_ratio * seen.depth_ratio.array());
  // Correlations by how many of the nodes that count lie between.
  const Eigen::Index nodes = solid_.angle_rad().size() / kNodeStep + 1;
  const double step_rad = solid_.angle_rad()[kNodeStep] - solid_.angle_rad()[0];
  Eigen::VectorXd model(nodes), edge(nodes);
  for (Eigen::Index k = 0; k < nodes; ++k) {
    model[k] = kernel(static_cast<double>(k) * step_rad, kModel_rad);
    edge[k] = kernel(static_cast<double>(k) * step_rad, kEdge_rad);
  }
  Eigen::MatrixXd covariance(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    double last_ratio = seen.depth_ratio[j], same_model = 1.0;  // of the contour that row i is of
    for (Eigen::Index i = j; i < n; ++i) {
      const double deeper = seen.depth_ratio[i] - seen.depth_ratio[j];
      if (seen.depth_ratio[i] != last_ratio) {
        last_ratio = seen.depth_ratio[i];
        same_model = kernel(deeper, kModelDepth_ratio);
      }
      const int apart = std::abs(seen.node[static_cast<std::size_t>(i)] - seen.node[static_cast<std::size_t>(j)]);
      double& sum = covariance(i, j);
      sum = model_um[i] * model_um[j] * model[apart] * same_model + kEdge_um * kEdge_um * edge[apart];
      sum += kPlace_um * kPlace_um * seen.normal_z[i] * seen.normal_z[j];
      sum += kRadius_um * kRadius_um;
      if (deeper == 0.0) {
        const double depth_um = std::max(kDepth_um, seen.depth_um[j]), edge_um = seen.edge_um[j];
        sum += depth_um * depth_um * seen.depth_slope[i] * seen.depth_slope[j] + edge_um * edge_um * edge[apart];
      }
      if (i == j) sum += kNoise_um * kNoise_um;
    }
  }
  return covariance;
}

void ContourSizes::give_up() noexcept {
  is_settled_ = true;
  estimate_.reset();
}

void ContourSizes::step(ParametersPrior prior) {
  if (is_settled_) return;
  bool has_open = false;
  for (int p = 0; p < kParameters; ++p) has_open = has_open || is_open(prior, p);
  if (!has_open) return give_up();
  prior.mean[kElongation] = elongation_;
  prior.sigma[kElongation] = kElongation_sigma;
  const Information weight = prior.sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  if (!at_) at_ = solid_.within_range(prior.mean);
  const bool has_held = hold_against_solid();
  if (std::any_of(contours_.begin(), contours_.end(), [](const Seen& seen) { return !seen.at; })) return;

  const Misfit seen = misfit_of_all();
  const Eigen::Index n = seen.residual_um.size();
  if (n < kFewestNodes) return give_up();
  const Eigen::LLT<Eigen::MatrixXd, Eigen::Lower> factor(covariance_um2(seen));
  const Eigen::Matrix<double, Eigen::Dynamic, kParameters> weighed = factor.solve(seen.slope_um);
  const Information information = weight + seen.slope_um.transpose() * weighed;
  const SolidParameters gradient = weighed.transpose() * seen.residual_um - weight * (*at_ - prior.mean);
  const SolidParameters next = solid_.within_range(*at_ + step_within(information, gradient, *at_));
  const double moved = (next - *at_).cwiseAbs().maxCoeff();
  at_ = next;
  is_settled_ = ++steps_ >= kMostSteps || (!has_held && moved <= kLastStep);
  const double misfit = seen.residual_um.dot(factor.solve(seen.residual_um));
  if (misfit > kLargestMisfit * static_cast<double>(n)) {
    if (is_settled_) estimate_.reset();
    return;
  }
  Parameters found{next, information.inverse()};
  for (int p = 0; p < kParameters; ++p) {
    if (is_open(prior, p)) continue;
    found.mean[p] = prior.mean[p];
    found.covariance.row(p).setZero();
    found.covariance.col(p).setZero();
    found.covariance(p, p) = prior.sigma[p] * prior.sigma[p];
  }
  estimate_ = found;
}

ContourSizes::ForceChange ContourSizes::force_change(const SolidParameters& from, const SolidParameters& to,
                                                     double depth_ratio) const {
  ForceChange change;
  const IndentedSolid::Load before = solid_.load(from, depth_ratio), after = solid_.load(to, depth_ratio);
  change.log_ratio = after.log_force - before.log_force;
  change.log_pressure_ratio = after.log_pressure - before.log_pressure;
  change.by_depth = after.by_depth - before.by_depth;
  change.slope = after.by_parameter;
  return change;
}

}  // namespace pellucida
