#pragma once
#include <functional>
#include <stop_token>

#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

struct GeometrySurveyOptions {
  int cell_count = 200;  ///< geometries drawn, 60 or more
  int threads = 0;       ///< 0: as many as the machine has cores
};

/// Identifies how force and pressure of a profile's springs err, by the depth at its own geometry (powers 0 to 6 of
/// the depth; the force's factor is 1 at the puncture's depth) and at others: draws geometries evenly
/// over ln h/R, ln a/R and ln o/R (Halton's sequence: the same each time), computes each by the solid of revolution
/// (`SolidReference`) and by the springs (`force_curve`), and fits the logarithm of their ratio, over that at the
/// profile's own geometry, by least squares: all products of powers that sum to 1 to 3, times powers 0 to 3 of the
/// depth. Writes `geometry_terms`, `geometry_pressure_terms` and `geometry_range` with the spread that an eightfold
/// cross-validation leaves and the scale of the shipped solid (`solid_force_ratio`), and the solid's entry of `errors`
/// anew. Precondition: the profile has constants. Throws
/// UsageError for too few cells, NothingMeasuredError where too few of them have an equilibrium, Error (internal error)
/// on cancellation.
void survey_geometry(CellProfile& profile, const GeometrySurveyOptions& options,
                     const std::function<void(double share)>& progress = {}, const std::stop_token& cancel = {});

}  // namespace pellucida
