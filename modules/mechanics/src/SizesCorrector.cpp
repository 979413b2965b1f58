#include "SizesCorrector.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// Contours say sizes where the needle comes from opposite the holder to within this, and through the cell's middle to
/// within this share of its radius: the solid that they are held against is of revolution.
constexpr double kOpposite_cos = 0.94, kThroughMiddle_ratio = 0.15;
/// How far the sizes in use go towards what the contours say, per frame.
constexpr double kFollow = 0.2;
/// A change below this (ln) is none.
constexpr double kLeastChange = 1e-3;
/// What the solid's force, as a smooth function of sizes, is off by (ln), where they change by so much or more.
constexpr double kFit_log = 0.04, kFitFrom_log = 0.5;
/// For the derivative by depth, over the radius.
constexpr double kDepthStep_ratio = 0.01;

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
  seen_.reset();
  change_.setZero();
}

void SizesCorrector::forget() {
  clear();
  contours_.forget();
}

SizesCorrection SizesCorrector::follow(const Observation& o, const CellPlacement& placement, const CellModelCache& cell,
                                       double depth_um, bool is_doubted) {
  const MembraneGeometry& built = cell.built_geometry();
  radius_um_ = cell.outer_radius_um();
  const double depth_ratio = depth_um / radius_um_;
  const LogSizes from(std::log(built.thickness_um / radius_um_), std::log(built.tip_radius_um / radius_um_),
                      std::log(built.holder_radius_um / radius_um_));
  const bool is_news = !is_doubted && is_of_revolution(placement, radius_um_) && contours_.add(o, placement, depth_um);
  if (is_news) seen_ = contours_.estimate({from, cell.geometry().log_sigmas()});
  const LogSizes wanted = seen_ ? LogSizes(seen_->mean - from) : LogSizes::Zero();
  change_ += kFollow * (wanted - change_);

  SizesCorrection correction;
  ratio_ = 1.0;
  if (!seen_ && change_.norm() < kLeastChange) return correction;
  const LogSizes to = from + change_;
  const auto change = contours_.force_change(from, to, depth_ratio);
  const auto deeper = contours_.force_change(from, to, depth_ratio + kDepthStep_ratio);
  ratio_ = correction.ratio = std::exp(change.log_ratio);
  correction.pressure_ratio = std::exp(change.log_pressure_ratio);
  correction.push_ratio = correction.pressure_ratio * std::pow(inner_over_middle(to) / inner_over_middle(from), 2);
  correction.slope_per_um = ratio_ * (deeper.log_ratio - change.log_ratio) / (kDepthStep_ratio * radius_um_);
  if (!seen_) return correction;
  const double by_sizes = std::sqrt(change.slope.dot(seen_->covariance * change.slope));
  const double not_yet = (wanted - change_).dot(change.slope);
  correction.log_sigma = std::hypot(by_sizes, not_yet, kFit_log * std::min(1.0, change_.norm() / kFitFrom_log));
  return correction;
}

std::optional<SizesByContour> SizesCorrector::sizes() const {
  if (!seen_) return std::nullopt;
  const LogSizes sigma = seen_->covariance.diagonal().cwiseSqrt();
  const auto length_um = [&](int size) { return radius_um_ * std::exp(seen_->mean[size]); };
  return SizesByContour{.contour_count = contours_.contour_count(),
                        .thickness_um = length_um(0),
                        .tip_radius_um = length_um(1),
                        .holder_radius_um = length_um(2),
                        .thickness_sigma = sigma[0],
                        .tip_radius_sigma = sigma[1],
                        .holder_radius_sigma = sigma[2],
                        .force_ratio = ratio_};
}

}  // namespace pellucida
