#include "ObservationCheck.h"

#include <cmath>

namespace pellucida {
namespace {

/// A profile speaks of cells of its own size: outside this share of its radius it says nothing.
constexpr double kSmallestRatio = 0.6;
constexpr double kLargestRatio = 1.7;

std::string whole(double value) {
  return std::to_string(std::lround(value));
}

}  // namespace

bool has_cell(const Observation& o) noexcept {
  return o.state != CellState::kNoCell && o.state != CellState::kLost && o.outer;
}

std::string why_not_measured(const Observation& o, const CellProfile& profile) {
  if (!has_cell(o) && o.refused_radius_um > 0.0) {
    return "what looks like a cell has a radius of " + whole(o.refused_radius_um) + " um, profile " + profile.name +
           " one of " + whole(profile.mid_radius_um) +
           " um; check the pixel size, give another profile, or click the cell";
  }
  if (!has_cell(o)) return "no cell to measure";
  if (!o.center_um.allFinite() || !std::isfinite(o.rest_beyond_um) || !std::isfinite(o.rest_outer_radius_um) ||
      o.rest_outer_radius_um <= 0.0) {
    return "the cell's rest shape is not known";
  }
  const double ratio = o.rest_outer_radius_um / (profile.mid_radius_um + 0.5 * profile.thickness_um);
  if (ratio >= kSmallestRatio && ratio <= kLargestRatio) return {};
  return "no cell of profile " + profile.name + ": its radius is " + whole(o.rest_outer_radius_um) +
         " um, the profile's " + whole(profile.mid_radius_um) + " um; check the pixel size, or give another profile";
}

}  // namespace pellucida
