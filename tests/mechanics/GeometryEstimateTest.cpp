#include "GeometryEstimate.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

Observation at_rest(double outer_um, double inner_um) {
  Observation o;
  o.state = CellState::kFree;
  o.rest_outer_radius_um = outer_um;
  o.rest_inner_radius_um = inner_um;
  return o;
}

TEST(GeometryEstimate, TakesTheThicknessThatIsSeen) {
  const CellProfile profile = load_profile("mouse-oocyte");
  GeometryEstimate estimate(profile);
  estimate.update(at_rest(48.0, 41.0));
  EXPECT_FALSE(estimate.thickness_assumed());
  EXPECT_DOUBLE_EQ(estimate.geometry().thickness_um, 7.0);
  EXPECT_DOUBLE_EQ(estimate.geometry().mid_radius_um, 44.5);
}

// Unseen, or both contours on one edge, as of a zona of two pixels: the profile's thickness, and a wide interval.
TEST(GeometryEstimate, AssumesTheProfilesWhereNoneIsSeen) {
  const CellProfile profile = load_profile("mouse-oocyte");
  GeometryEstimate seen(profile);
  seen.update(at_rest(48.0, 43.0));
  for (const double inner_um : {0.0, 47.8, 48.0, 48.5}) {
    GeometryEstimate estimate(profile);
    estimate.update(at_rest(48.0, inner_um));
    EXPECT_TRUE(estimate.thickness_assumed()) << inner_um;
    EXPECT_DOUBLE_EQ(estimate.geometry().thickness_um, profile.thickness_um) << inner_um;
    EXPECT_GT(estimate.force_sigma_ratio(), seen.force_sigma_ratio()) << inner_um;
  }
}

}  // namespace
}  // namespace pellucida
