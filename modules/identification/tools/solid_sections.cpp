// A developer's tool: the outer sections of solids of revolution under a needle, for all geometries of a survey. What
// resources/shapes/indented_solid.py is fitted to.
//   solid_sections COUNT > FILE.csv
// A row an equilibrium: cell, thickness, tip, holder (um), the wall's stiffening, its length over width, indentation
// (um, on a middle radius of 50 um), force (uN), pressure (kPa), then x and z (um) of the outer surface at rest angles
// 2 degrees apart from the needle's pole. Each geometry three times: round and neo-Hookean, of a wall that stiffens,
// and out of round.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>

#include "SurveyedSolid.h"
#include "pellucida/core/Error.h"

namespace {

using namespace pellucida;

constexpr double kRadius_um = 50.0;
constexpr int kStep_deg = 2;

void print(int cell, const MembraneGeometry& geometry, const SurveyedWall& wall, const Eigen::VectorXd& angle_rad,
           const SolidStep& step) {
  std::printf("%d,%.6f,%.6f,%.6f,%.6f,%.6f,%.4f,%.6g,%.6g", cell, geometry.thickness_um, geometry.tip_radius_um,
              geometry.holder_radius_um, wall.stiffening, wall.aspect_ratio, step.indentation_um, step.force_uN,
              step.pressure_kPa);
  Eigen::Index j = 0;
  for (int angle_deg = 0; angle_deg <= 180; angle_deg += kStep_deg) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    while (j + 2 < angle_rad.size() && angle_rad[j + 1] < angle) ++j;
    const double t = (angle - angle_rad[j]) / (angle_rad[j + 1] - angle_rad[j]);
    const Eigen::Vector2d place = (1.0 - t) * step.outer_um.col(j) + t * step.outer_um.col(j + 1);
    std::printf(",%.5f,%.5f", place.x(), place.y());
  }
  std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const int cells = count == 2 ? std::atoi(arguments[1]) : 0;
    if (cells < 1) throw UsageError("solid_sections COUNT");
    const CellProfile profile = load_profile("mouse-oocyte");
    for (int k = 1; k <= cells; ++k) {
      const MembraneGeometry geometry = surveyed_geometry(k, kRadius_um);
      const SurveyedWall all = surveyed_wall(k);
      for (const SurveyedWall& wall :
           {SurveyedWall{}, {.stiffening = all.stiffening}, {.aspect_ratio = all.aspect_ratio}}) {
        SolidReference solid = surveyed_solid(profile, geometry, wall);
        const SolidCurve curve = solid.run(kSurveyDeepest_ratio * kRadius_um, kSurveyStep_ratio * kRadius_um);
        for (const SolidStep& step : curve.steps) print(k, geometry, wall, solid.rest_angle_rad(), step);
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "solid_sections: %s\n", error.what());
    return 1;
  }
  return 0;
}
