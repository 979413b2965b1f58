#include "pellucida/microscopy/GlassShape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pellucida {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
// A spike is a third as wide as the glass it grows from.
constexpr double kSpikeWidth_ratio = 0.33;

}  // namespace

double NeedleShape::outer_radius_um(double back_um) const noexcept {
  const double r = tip_radius_um, start = look.end == "bevelled" ? look.spike_um : 0.0, back = back_um - start;
  if (back < 0) return 0.0;
  const bool closed = look.end == "closed";
  if (closed && back < r) return std::sqrt(std::max(0.0, r * r - (r - back) * (r - back)));
  const double widening = shaft_radius_um - r, slope = std::tan(taper_deg * kRadiansPerDegree);
  return widening <= 0 ? r : r + widening * -std::expm1(-(back - (closed ? r : 0.0)) * slope / widening);
}

double NeedleShape::lumen_radius_um(double back_um) const noexcept {
  // A closed needle is solid up to a little behind its tip.
  const double solid = look.end == "closed" ? 2 * tip_radius_um : 0.0;
  if (back_um < solid) return 0.0;
  const double opening = solid > 0 ? std::min(1.0, (back_um - solid) / solid) : 1.0;
  return look.lumen_ratio * std::sqrt(opening) * outer_radius_um(back_um);
}

double NeedleShape::middle_um() const noexcept {
  return look.end == "bevelled" ? tip_radius_um : 0.0;
}

double NeedleShape::inside_cut_um(double back_um, double lateral_um) const noexcept {
  if (look.end != "bevelled") return std::numeric_limits<double>::infinity();
  const double angle = look.bevel_deg * kRadiansPerDegree;
  return (back_um - look.spike_um) * std::sin(angle) - lateral_um * std::cos(angle);
}

double NeedleShape::spike_radius_um(double back_um) const noexcept {
  if (look.end != "bevelled" || look.spike_um <= 0 || back_um < 0) return 0.0;
  // It reaches back to where the cut tube is as wide.
  const double base = kSpikeWidth_ratio * tip_radius_um;
  if (back_um > look.spike_um + 2 * base / std::tan(look.bevel_deg * kRadiansPerDegree)) return 0.0;
  return base * std::min(1.0, back_um / look.spike_um);
}

std::pair<double, double> NeedleShape::span_um(double back_um) const noexcept {
  const double spike = spike_radius_um(back_um), radius = outer_radius_um(back_um), middle = middle_um();
  double low = middle - radius, high = middle + radius;
  if (look.end == "bevelled") {
    const double cut = (back_um - look.spike_um) * std::tan(look.bevel_deg * kRadiansPerDegree);
    high = std::min(high, std::max(cut, low));
    if (back_um <= look.spike_um) low = high = 0.0;
  }
  if (spike > 0) {
    low = std::min(low, 0.0);
    high = std::max(high, 2 * spike);
  }
  return {low, std::max(low, high)};
}

double HolderShape::half_wall_um(double back_um) const noexcept {
  const double rim = rim_radius_um(), before = rim - back_um;
  if (before <= 0) return rim;
  return std::sqrt(std::max(0.0, rim * rim - before * before));
}

double HolderShape::middle_um(double back_um) const noexcept {
  // Straight for two radii, then an arc.
  const double along = std::max(0.0, back_um - 2 * outer_radius_um);
  return 0.5 * bend_per_um * along * along;
}

}  // namespace pellucida
