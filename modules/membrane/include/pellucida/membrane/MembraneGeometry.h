#pragma once
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// Sizes of one cell at rest and of the tools on it, um. They decide a force as much as the modulus does: at 44 um it
/// goes with about R^-1.9, h^1.2, a^0.4 and with the holder's width.
struct MembraneGeometry {
  double mid_radius_um = 0.0;     ///< R, of the zona's middle surface
  double thickness_um = 0.0;      ///< h, of the zona
  double tip_radius_um = 0.0;     ///< a, of the needle
  double holder_radius_um = 0.0;  ///< o, outer, of the ring on which the holding pipette bears
};

/// The geometry that a profile's constants were identified at.
MembraneGeometry geometry_of(const CellProfile& profile);

/// How far apart two geometries are in shape: root of the sum of squares of the differences of ln h/R, ln a/R, ln o/R;
/// 0 where they differ in size alone. Precondition: all lengths above 0.
double shape_distance(const MembraneGeometry& a, const MembraneGeometry& b) noexcept;

/// The profile for a cell of its kind but of another geometry: tools, bonds (their density times the tool's radius
/// stays), the regions' angles and the mesh's grading follow; material and constants stay. A tip finer than
/// `kFinestTip_ratio` of the radius is modelled as wide as that, since the mesh can't carry a finer one; the correction
/// knows the difference. Precondition: all lengths above 0.
CellProfile adapted_to(const CellProfile& profile, const MembraneGeometry& geometry);

/// The rule for the angles at which the regions of tip and holder end: the tool's reach and about a bending length,
/// sqrt(R h), beyond; and for the mesh: even where the tip's radius is a tenth of the cell's, finer at the needle for a
/// finer tip.
void set_regions(CellProfile& profile);

inline constexpr double kFinestTip_ratio = 0.08;

/// What the springs' force is multiplied by to be the solid's: at the profile's own geometry a function of the depth, 1
/// at the puncture's, where the modulus was set; 1 everywhere without terms.
struct GeometryFactor {
  double ratio = 1.0;         ///< on the force
  double slope_per_um = 0.0;  ///< its derivative by depth: stiffness = ratio k + slope F
};

/// ln ratio = sum of c x^i y^j z^k t^p over the profile's terms, x = ln of (h/R over the profile's), y and z likewise
/// of a/R and o/R, t = depth / R. Held at the border of the range that the terms were fitted in.
GeometryFactor geometry_factor(const CellProfile& profile, const MembraneGeometry& geometry, double depth_um) noexcept;

/// The same for the liquid's pressure, by the profile's `geometry_pressure_terms`: a thick wall yields under the needle
/// by itself, so that the pressure falls behind the force. Without such terms the force's ratio.
double pressure_factor(const CellProfile& profile, const MembraneGeometry& geometry, double depth_um) noexcept;

/// True where one of h/R, a/R, o/R lies outside the range that the terms were fitted in.
bool is_beyond_range(const CellProfile& profile, const MembraneGeometry& geometry) noexcept;

}  // namespace pellucida
