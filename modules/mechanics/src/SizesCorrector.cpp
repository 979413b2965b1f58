#include "SizesCorrector.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// Contours say sizes where the needle comes from opposite the holder to within this, and through the cell's middle to
/// within this share of its radius: the solid that they are held against is of revolution.
constexpr double kOpposite_cos = 0.94, kThroughMiddle_ratio = 0.15;
/// How far the sizes in use go towards what the contours say, per frame.
constexpr double kFollow = 0.5;
/// How walls of one kind stiffen, `stiffening_effect`: 0 with this standard deviation, and never below. Set on GetFEM
/// specimens (docs/method.md, 4.4).
constexpr double kStiffening_sigma = 0.4;
/// How much of what an outline's elongation does to the force is left open by the width across the picture.
constexpr double kOtherWidth_ratio = 0.4;
/// A change below this (ln) is none.
constexpr double kLeastChange = 1e-3;
/// What the solid's force, as a smooth function of sizes, is off by (ln): 0.03 on cells left out of the fit, 0.02 to
/// 0.03 on GetFEM specimens; springs that it moves by so much or more have all of it.
constexpr double kFit_log = 0.03, kFitFrom_log = 0.5;

bool is_of_revolution(const CellPlacement& placement, double radius_um) {
  return !placement.holder_assumed() && placement.holder().dot(placement.push()) > kOpposite_cos &&
         std::abs(placement.offset_um()) < kThroughMiddle_ratio * radius_um;
}

/// Radius of the zona's inner face over that of its middle.
double inner_over_middle(const LogSizes& sizes) {
  const double thickness = std::exp(sizes[0]);
  return (1.0 - thickness) / (1.0 - 0.5 * thickness);
}

}  // namespace

void SizesCorrector::clear() noexcept {
  contours_.clear();
  change_.setZero();
}

void SizesCorrector::forget() {
  clear();
  contours_.forget();
}

SizesCorrection SizesCorrector::follow(const Observation& o, const CellPlacement& placement, const CellModelCache& cell,
                                       double depth_um, double depth_sigma_um, bool is_doubted,
                                       const CellScale& scale) {
  const MembraneGeometry& built = cell.built_geometry();
  radius_um_ = cell.outer_radius_um();
  const double depth_ratio = depth_um / radius_um_;
  const SolidParameters from(std::log(built.thickness_um / radius_um_), std::log(built.tip_radius_um / radius_um_),
                             std::log(built.holder_radius_um / radius_um_), 0.0, 0.0);
  const bool is_solid = is_of_revolution(placement, radius_um_);
  const double elongation = is_solid ? contours_.elongation() : 0.0;
  if (!is_doubted && is_solid) contours_.add(o, placement, depth_um, depth_sigma_um);
  if (!contours_.is_settled()) {
    LogSizes sigmas = cell.geometry().log_sigmas();
    if (scale.has_geometry) sigmas = sigmas.cwiseMin(ContourSizes::kOpen);
    has_open_size_ = (sigmas.array() > ContourSizes::kOpen).any();
    contours_.step({from, (SolidParameters() << sigmas, kStiffening_sigma, 0.0).finished()});
  }
  const auto& seen = contours_.estimate();
  SolidParameters wanted = seen ? SolidParameters(seen->mean - from) : SolidParameters::Zero();
  wanted[kElongation] = elongation;
  change_ += kFollow * (wanted - change_);
  change_[kElongation] = elongation;  // seen at rest already

  SizesCorrection correction;
  ratio_ = 1.0;
  const double solid_share = cell.indenter().solid_share();
  if (!seen && !is_solid && change_.norm() < kLeastChange) return correction;
  const SolidParameters to = from + change_;
  auto change = contours_.force_change(from, to, depth_ratio);
  if (scale.has_geometry) change -= contours_.force_change(from, to, scale.push_depth_um / radius_um_);
  ratio_ = correction.ratio = std::exp(change.log_ratio);
  correction.pressure_ratio = std::exp(change.log_pressure_ratio);
  correction.push_ratio =
      correction.pressure_ratio * std::pow(inner_over_middle(to.head<3>()) / inner_over_middle(from.head<3>()), 2);
  correction.elongation_log_sigma = kOtherWidth_ratio * std::abs(change.slope[kElongation] * elongation);
  correction.slope_per_um = ratio_ * change.by_depth / radius_um_;
  const SolidParameters not_yet = (wanted - change_).cwiseProduct(change.slope);
  if (seen) {
    correction.stiffening_log_sigma = std::hypot(
        std::sqrt(seen->covariance(kStiffening, kStiffening)) * change.slope[kStiffening], not_yet[kStiffening]);
  }
  const bool by_contours = seen && has_open_size_;
  if (!by_contours && !is_solid) return correction;
  // The force's law: the solid's fit, or that of the springs to it, and the solid's where that moves them far.
  const double moved = std::min(1.0, change_.head<3>().norm() / kFitFrom_log);
  const double springs = std::hypot(cell.geometry().springs_spread_ratio(), kFit_log * moved);
  const double fit = solid_share * kFit_log + (1.0 - solid_share) * springs;
  Eigen::Matrix3d covariance = cell.geometry().log_sigmas().cwiseAbs2().asDiagonal();
  if (by_contours) covariance = seen->covariance.topLeftCorner<3, 3>();
  const Eigen::Vector3d slope = change.slope.head<3>();
  const double by_sizes = std::sqrt(slope.dot(covariance * slope));
  correction.log_sigma = std::hypot(by_sizes, by_contours ? not_yet.head<3>().sum() : 0.0, fit);
  return correction;
}

std::optional<SizesByContour> SizesCorrector::sizes() const {
  const auto& seen = contours_.estimate();
  if (!seen) return std::nullopt;
  const SolidParameters sigma = seen->covariance.diagonal().cwiseSqrt();
  const auto length_um = [&](int size) { return radius_um_ * std::exp(seen->mean[size]); };
  return SizesByContour{.contour_count = contours_.contour_count(),
                        .thickness_um = length_um(0),
                        .tip_radius_um = length_um(1),
                        .holder_radius_um = length_um(2),
                        .thickness_sigma = sigma[0],
                        .tip_radius_sigma = sigma[1],
                        .holder_radius_sigma = sigma[2],
                        .sizes_changed = has_open_size_,
                        .stiffening_effect = seen->mean[kStiffening],
                        .stiffening_effect_sigma = sigma[kStiffening],
                        .force_ratio = ratio_};
}

}  // namespace pellucida
