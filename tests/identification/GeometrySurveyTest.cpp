#include "pellucida/identification/GeometrySurvey.h"

#include <gtest/gtest.h>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {
namespace {

TEST(GeometrySurvey, ASmallOneFindsTheShippedCorrection) {
  const CellProfile shipped = load_profile("mouse-oocyte");
  CellProfile profile = shipped;
  survey_geometry(profile, {.cell_count = 80});
  EXPECT_EQ(profile.geometry_range.cell_count, 80);
  EXPECT_GT(profile.geometry_range.spread_ratio, 0.01);
  EXPECT_LT(profile.geometry_range.spread_ratio, 0.5);
  ASSERT_EQ(profile.geometry_terms.size(), shipped.geometry_terms.size());
  // The depth's own terms come from the profile's own geometry alone.
  for (const double depth_um : {2.0, 10.0, 25.0, 44.0}) {
    const MembraneGeometry own = geometry_of(profile);
    EXPECT_NEAR(geometry_factor(profile, own, depth_um).ratio, geometry_factor(shipped, own, depth_um).ratio, 1e-3);
    EXPECT_NEAR(pressure_factor(profile, own, depth_um), pressure_factor(shipped, own, depth_um), 1e-3);
  }
  // So does the solid's scale.
  EXPECT_NEAR(profile.geometry_range.solid_force_ratio / shipped.geometry_range.solid_force_ratio, 1.0, 1e-3);
  ASSERT_EQ(profile.errors.size(), shipped.errors.size());
  EXPECT_NEAR(profile.errors.back().largest_ratio, shipped.errors.back().largest_ratio, 1e-4);
  EXPECT_LT(profile.errors.back().largest_ratio, 0.02);
  for (const MembraneGeometry& geometry :
       {MembraneGeometry{50, 8, 3, 25}, {50, 4, 6, 18}, {45, 6, 2, 20}, {58, 10, 5, 30}})
    for (const double depth_um : {10.0, 25.0, 40.0}) {
      const double ratio = geometry_factor(shipped, geometry, depth_um).ratio;
      EXPECT_NEAR(geometry_factor(profile, geometry, depth_um).ratio, ratio, 0.1 * ratio)
          << geometry.thickness_um << " um thick, " << depth_um << " um deep";
      const double of_pressure = pressure_factor(shipped, geometry, depth_um);
      EXPECT_NEAR(pressure_factor(profile, geometry, depth_um), of_pressure, 0.1 * of_pressure)
          << geometry.thickness_um << " um thick, " << depth_um << " um deep";
    }
}

TEST(GeometrySurvey, RefusesTooFewAndChangesNothingWhenCancelled) {
  CellProfile profile = load_profile("mouse-oocyte");
  const std::string before = to_json(profile);
  EXPECT_THROW(survey_geometry(profile, {.cell_count = 59}), UsageError);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(survey_geometry(profile, {.cell_count = 60}, {}, source.get_token()), Error);
  EXPECT_EQ(to_json(profile), before);
}

}  // namespace
}  // namespace pellucida
