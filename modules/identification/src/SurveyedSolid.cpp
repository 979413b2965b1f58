#include "SurveyedSolid.h"

#include <cmath>

#include "ProfileSpecimen.h"
#include "pellucida/membrane/IndentedSolid.h"

namespace pellucida {
namespace {

/// Longer elements than the default: at finer ones the surface beside a fine tip creases and no equilibrium is found.
constexpr double kEdgeLength_ratio = 1.6;

constexpr double kSurveyStiffening[] = {0.03, 0.6}, kSurveyAspect_ratio[] = {1.0 / 1.2, 1.2};

/// Member `index` of Halton's sequence in a base, 0 to 1.
double halton(int index, int base) {
  double share = 1.0, value = 0.0;
  for (int i = index; i > 0; i /= base) {
    share /= base;
    value += share * (i % base);
  }
  return value;
}

double evenly_in_log(double place, const double (&range)[2]) {
  return range[0] * std::pow(range[1] / range[0], place);
}

}  // namespace

MembraneGeometry surveyed_geometry(int index, double mid_radius_um) {
  return {mid_radius_um, mid_radius_um * evenly_in_log(halton(index, 2), kSurveyThickness_ratio),
          mid_radius_um * evenly_in_log(halton(index, 3), kSurveyTip_ratio),
          mid_radius_um * evenly_in_log(halton(index, 5), kSurveyHolder_ratio)};
}

SurveyedWall surveyed_wall(int index) {
  const double place = halton(index, 7);
  const double effect =
      (1.0 - place) * stiffening_effect(kSurveyStiffening[0]) + place * stiffening_effect(kSurveyStiffening[1]);
  return {stiffening_of(effect), evenly_in_log(halton(index, 11), kSurveyAspect_ratio)};
}

SolidReference surveyed_solid(const CellProfile& profile, const MembraneGeometry& geometry, const SurveyedWall& wall) {
  ShellSpecimen specimen = specimen_of(profile);
  specimen.mid_radius_um = geometry.mid_radius_um;
  specimen.thickness_um = geometry.thickness_um;
  const CellProfile cell = adapted_to(profile, geometry);
  ShellContact contact;
  contact.tip_radius_um = geometry.tip_radius_um;  // not as wide as the springs' mesh needs it
  contact.tip_bond_per_um = profile.tip_bond_per_um * profile.tip_radius_um / geometry.tip_radius_um;
  contact.holder_ring_um = cell.holder_ring_um;
  contact.holder_half_width_um = cell.holder_half_width_um;
  contact.holder_bond_per_um = cell.holder_bond_per_um;
  return {specimen,
          contact,
          {.edge_length_ratio = kEdgeLength_ratio, .stiffening = wall.stiffening, .aspect_ratio = wall.aspect_ratio}};
}

}  // namespace pellucida
