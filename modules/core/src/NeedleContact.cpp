#include "pellucida/core/NeedleContact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace pellucida {
namespace {

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

NeedleContact needle_contact(const Observation& observation) {
  const Eigen::Vector2d along = observation.needle->direction;
  const Eigen::Vector2d left(-along.y(), along.x());
  const Eigen::Vector2d to_center = observation.center_um - observation.needle->tip_um;
  const double radius_um = observation.rest_outer_radius_um + observation.rest_beyond_um;
  NeedleContact contact;
  contact.offset_um = left.dot(to_center);
  const double across_um = std::clamp(contact.offset_um, -radius_um, radius_um);
  const double half_chord_um = std::sqrt(std::max(0.0, radius_um * radius_um - across_um * across_um));
  contact.entry_um = observation.center_um - across_um * left - half_chord_um * along;
  contact.tip_depth_um = along.dot(observation.needle->tip_um - contact.entry_um);
  return contact;
}

double flank_depth_um(const Observation& o, const NeedleContact& contact) {
  const Eigen::Vector2d entry = (contact.entry_um - o.center_um).normalized();
  const auto outer = flank_of(o.outer, o.rest_outer_radius_um, o.rest_beyond_um, o.center_um, entry);
  const auto inner = flank_of(o.inner, o.rest_inner_radius_um, o.rest_beyond_um, o.center_um, entry);
  if (outer && inner) return 0.5 * (*outer + *inner);
  return outer.value_or(inner.value_or(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace pellucida
