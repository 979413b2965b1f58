#include "ContactSight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace pellucida {
namespace {

/// Noise of the indentation when the tracker gives none: a quarter of a pixel at 0.8 um; and of the tip along the
/// needle.
constexpr double kDefaultDepthSigma_um = 0.2, kDefaultTipSigma_um = 0.4;
/// Where the flanks lie, from the entry.
constexpr double kFlankFrom_rad = 12.0 * std::numbers::pi / 180.0, kFlankTo_rad = 40.0 * std::numbers::pi / 180.0;
/// So many points at least make a flank.
constexpr int kLeastPoints = 6;

/// `beyond_um`: of the resting outline at the entry; beside it that of an ellipse.
std::optional<double> flank_of(const std::optional<MembraneContour>& contour, double rest_radius_um, double beyond_um,
                               const Eigen::Vector2d& center_um, const Eigen::Vector2d& entry) {
  if (!contour || !(rest_radius_um > 0.0)) return std::nullopt;
  const double near = std::cos(kFlankFrom_rad), far = std::cos(kFlankTo_rad);
  double sum_um = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < contour->points_um.cols(); ++i) {
    const Eigen::Vector2d d = contour->points_um.col(i) - center_um;
    const double distance_um = d.norm(), cosine = d.dot(entry) / std::max(distance_um, 1e-9);
    if (cosine > near || cosine < far) continue;
    sum_um += rest_radius_um + beyond_um * (2.0 * cosine * cosine - 1.0) - distance_um;
    ++count;
  }
  return count < kLeastPoints ? std::nullopt : std::optional(sum_um / count);
}

}  // namespace

double flank_depth_um(const Observation& o, const NeedleContact& contact) {
  const Eigen::Vector2d entry = (contact.entry_um - o.center_um).normalized();
  const auto outer = flank_of(o.outer, o.rest_outer_radius_um, o.rest_beyond_um, o.center_um, entry);
  const auto inner = flank_of(o.inner, o.rest_inner_radius_um, o.rest_beyond_um, o.center_um, entry);
  if (outer && inner) return 0.5 * (*outer + *inner);
  return outer.value_or(inner.value_or(std::numeric_limits<double>::quiet_NaN()));
}

PunctureVerdict::Sight sight_of(const Observation& o, const NeedleContact& contact) {
  PunctureVerdict::Sight sight;
  sight.is_tracked_punctured = o.state == CellState::kPunctured;
  sight.has_depths = o.needle && std::isfinite(o.indentation_um);
  if (!sight.has_depths) return sight;
  sight.tip_um = contact.tip_depth_um;
  sight.tip_sigma_um = o.needle->tip_sigma_um > 0.0 ? o.needle->tip_sigma_um : kDefaultTipSigma_um;
  sight.membrane_um = o.indentation_um;
  const bool has_sigma = std::isfinite(o.indentation_sigma_um) && o.indentation_sigma_um > 0.0;
  sight.membrane_sigma_um = has_sigma ? o.indentation_sigma_um : kDefaultDepthSigma_um;
  sight.rest_radius_um = o.rest_outer_radius_um;
  if (o.side_bulge_um > 0.0) sight.side_um = o.side_bulge_um;
  sight.flank_um = flank_depth_um(o, contact);
  // A needle's confidence is a product of several, each of which says how well it was seen.
  sight.confidence = std::min(o.confidence, std::sqrt(std::max(0.0, o.needle->confidence)));
  return sight;
}

}  // namespace pellucida
