#pragma once
#include "pellucida/fem/SolidReference.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {

/// The geometries that surveys go through, over the middle radius: a zona of 2.5 to 20 um on a cell of 50 um, tips of
/// 0.4 to 12, holders of 7.5 to 40 um.
inline constexpr double kSurveyThickness_ratio[] = {0.045, 0.40}, kSurveyTip_ratio[] = {0.008, 0.25},
                        kSurveyHolder_ratio[] = {0.15, 0.80};
/// The depths, over the middle radius.
inline constexpr double kSurveyStep_ratio = 0.04, kSurveyDeepest_ratio = 1.0;

/// Member `index` (1 on) of a sequence even in the logarithms of those sizes (Halton's: the same each time).
MembraneGeometry surveyed_geometry(int index, double mid_radius_um);

/// What else a wall may be, see `SolidOptions`.
struct SurveyedWall {
  double stiffening = 0.0, aspect_ratio = 1.0;
};
/// Of the same member: a stiffening of 0.03 to 0.6, even in `stiffening_effect`, and a length over width of 1/1.2 to
/// 1.2.
SurveyedWall surveyed_wall(int index);

/// The solid of the profile's material in that geometry, under the profile's bonds.
SolidReference surveyed_solid(const CellProfile& profile, const MembraneGeometry& geometry,
                              const SurveyedWall& wall = {});

}  // namespace pellucida
