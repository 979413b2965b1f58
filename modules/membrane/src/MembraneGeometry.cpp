#include "pellucida/membrane/MembraneGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "pellucida/core/FieldTable.h"

namespace pellucida {
namespace {

/// The mesh is even where the tip's radius is a tenth of the cell's, and finer at the needle for a sharper tip; a finer
/// mesh there is a coarser one at the holder.
constexpr double kEvenRadius_ratio = 0.1, kSteepestGrading = 1.8;

template <int kHighest>
std::array<double, kHighest + 1> powers_of(double value) noexcept {
  std::array<double, kHighest + 1> powers{1.0};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = powers[k - 1] * value;
  return powers;
}

std::array<double, 3> ratios_of(const MembraneGeometry& g) noexcept {
  return {g.thickness_um / g.mid_radius_um, g.tip_radius_um / g.mid_radius_um, g.holder_radius_um / g.mid_radius_um};
}

std::array<FieldRange, 3> ranges_of(const GeometryRange& range) noexcept {
  return {FieldRange{range.thickness_from_ratio, range.thickness_to_ratio},
          FieldRange{range.tip_from_ratio, range.tip_to_ratio},
          FieldRange{range.holder_from_ratio, range.holder_to_ratio}};
}

}  // namespace

MembraneGeometry geometry_of(const CellProfile& profile) {
  return {profile.mid_radius_um, profile.thickness_um, profile.tip_radius_um,
          profile.holder_ring_um + profile.holder_half_width_um};
}

double shape_distance(const MembraneGeometry& a, const MembraneGeometry& b) noexcept {
  const auto of_a = ratios_of(a), of_b = ratios_of(b);
  return std::hypot(std::log(of_a[0] / of_b[0]), std::log(of_a[1] / of_b[1]), std::log(of_a[2] / of_b[2]));
}

CellProfile adapted_to(const CellProfile& profile, const MembraneGeometry& geometry) {
  CellProfile cell = profile;
  cell.mid_radius_um = geometry.mid_radius_um;
  cell.thickness_um = geometry.thickness_um;
  cell.inner_radius_um = geometry.mid_radius_um - 0.5 * geometry.thickness_um;
  cell.tip_radius_um = std::max(geometry.tip_radius_um, kFinestTip_ratio * geometry.mid_radius_um);
  const double holder_ratio = geometry.holder_radius_um / (profile.holder_ring_um + profile.holder_half_width_um);
  cell.holder_ring_um *= holder_ratio;
  cell.holder_half_width_um *= holder_ratio;
  cell.tip_bond_per_um *= profile.tip_radius_um / cell.tip_radius_um;
  cell.holder_bond_per_um /= holder_ratio;
  set_regions(cell);
  return cell;
}

void set_regions(CellProfile& cell) {
  const double outer_um = cell.mid_radius_um + 0.5 * cell.thickness_um;
  const double bending_rad = std::sqrt(cell.thickness_um / cell.mid_radius_um);
  const double tip_rad = 2.0 * std::asin(std::min(1.0, 0.5 * cell.tip_radius_um / outer_um));
  const double holder_rad = std::asin(std::min(1.0, (cell.holder_ring_um + cell.holder_half_width_um) / outer_um));
  const auto rounded = [](double angle) { return std::min(1.5, 1e-3 * std::round(1e3 * angle)); };
  cell.tip_angle_rad = rounded(tip_rad + 0.8 * bending_rad);
  cell.holder_angle_rad = rounded(holder_rad + 1.13 * bending_rad);
  cell.mesh_grading = std::clamp(kEvenRadius_ratio * cell.mid_radius_um / cell.tip_radius_um, 1.0, kSteepestGrading);
}

namespace {

GeometryFactor factor_of(std::span<const GeometryTerm> terms, const CellProfile& profile,
                         const MembraneGeometry& geometry, double depth_um) noexcept {
  if (terms.empty()) return {};
  const auto own = ratios_of(geometry_of(profile)), other = ratios_of(geometry);
  const auto ranges = ranges_of(profile.geometry_range);
  std::array<std::array<double, kHighestSizePower + 1>, 3> log_power;
  for (std::size_t i = 0; i < 3; ++i)
    log_power[i] = powers_of<kHighestSizePower>(std::log(std::clamp(other[i], ranges[i].low, ranges[i].high) / own[i]));
  const double radius_um = geometry.mid_radius_um, deepest = profile.geometry_range.depth_to_ratio;
  const double depth = std::clamp(depth_um / radius_um, 0.0, deepest);
  const auto depth_power = powers_of<kHighestDepthPower>(depth);
  double sum = 0.0, slope = 0.0;
  for (const GeometryTerm& term : terms) {
    const auto at = [](const auto& powers, int power) { return powers[static_cast<std::size_t>(power)]; };
    const double value = term.coefficient * at(log_power[0], term.thickness) * at(log_power[1], term.tip) *
                         at(log_power[2], term.holder);
    sum += value * at(depth_power, term.depth);
    if (term.depth > 0) slope += value * term.depth * at(depth_power, term.depth - 1);
  }
  GeometryFactor factor;
  factor.ratio = std::exp(sum);
  if (depth_um < deepest * radius_um) factor.slope_per_um = factor.ratio * slope / radius_um;
  return factor;
}

}  // namespace

GeometryFactor geometry_factor(const CellProfile& profile, const MembraneGeometry& geometry, double depth_um) noexcept {
  return factor_of(profile.geometry_terms, profile, geometry, depth_um);
}

double pressure_factor(const CellProfile& profile, const MembraneGeometry& geometry, double depth_um) noexcept {
  const auto& own = profile.geometry_pressure_terms;
  return factor_of(own.empty() ? profile.geometry_terms : own, profile, geometry, depth_um).ratio;
}

bool is_beyond_range(const CellProfile& profile, const MembraneGeometry& geometry) noexcept {
  if (profile.geometry_terms.empty()) return false;
  const auto ratios = ratios_of(geometry);
  const auto ranges = ranges_of(profile.geometry_range);
  for (std::size_t i = 0; i < 3; ++i)
    if (!ranges[i].holds(ratios[i])) return true;
  return false;
}

}  // namespace pellucida
