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

// A zona whose edge would have been seen from some distance on is thinner than that, most likely. A limit far beyond
// the profile's thickness says little, and so does one that no zona of the kind would reach: there the edge has no
// contrast.
TEST(GeometryEstimate, AnEdgeThatIsMissedBoundsTheThickness) {
  const CellProfile profile = load_profile("mouse-oocyte");
  double last_um = 0.0;
  for (const double limit_um : {3.0, 4.0, 6.0, 9.0}) {
    GeometryEstimate estimate(profile);
    Observation o = at_rest(48.0, 0.0);
    o.rest_thickness_limit_um = limit_um;
    estimate.update(o);
    EXPECT_TRUE(estimate.thickness_assumed());
    EXPECT_GT(estimate.geometry().thickness_um, last_um);
    EXPECT_LT(estimate.geometry().thickness_um, profile.thickness_um);
    last_um = estimate.geometry().thickness_um;
  }
  EXPECT_GT(last_um, 0.8 * profile.thickness_um);
  GeometryEstimate tiny(profile);
  Observation o = at_rest(48.0, 0.0);
  o.rest_thickness_limit_um = 0.5;
  tiny.update(o);
  EXPECT_NEAR(tiny.geometry().thickness_um, profile.thickness_um, 0.1 * profile.thickness_um);
}

// What wasn't taken from contours is less sure.
TEST(GeometryEstimate, AThicknessCountsAsSurelyAsItWasRead) {
  const CellProfile profile = load_profile("mouse-oocyte");
  GeometryEstimate sure(profile), unsure(profile);
  Observation o = at_rest(48.0, 45.0);
  sure.update(o);
  o.rest_thickness_sigma_um = 0.6;
  unsure.update(o);
  EXPECT_DOUBLE_EQ(sure.geometry().thickness_um, unsure.geometry().thickness_um);
  EXPECT_GT(unsure.force_sigma_ratio(), 1.05 * sure.force_sigma_ratio());
}

// Two pixels of something are no holding pipette; a narrow one is.
TEST(GeometryEstimate, AHolderOfNoLikelyWidthIsNone) {
  const CellProfile profile = load_profile("mouse-oocyte");
  GeometryEstimate unseen(profile);
  unseen.update(at_rest(48.0, 43.0));
  for (const double holder_um : {0.8, 7.5, 40.0, 90.0}) {
    GeometryEstimate estimate(profile);
    Observation o = at_rest(48.0, 43.0);
    o.holder.emplace();
    o.holder->outer_radius_um = holder_um;
    estimate.update(o);
    const bool is_one = holder_um > 5.0 && holder_um < 60.0;
    EXPECT_NEAR(estimate.geometry().holder_radius_um, is_one ? holder_um : unseen.geometry().holder_radius_um, 1e-9);
    EXPECT_EQ(estimate.force_sigma_ratio() < 0.9 * unseen.force_sigma_ratio(), is_one) << holder_um;
  }
}

// A tip counts as it is read; the less surely, the wider the interval.
TEST(GeometryEstimate, ATipSeenPoorlyWidensTheInterval) {
  const CellProfile profile = load_profile("mouse-oocyte");
  double last_sigma = 0.0;
  for (const double sigma : {0.1, 0.4, 1.2}) {
    GeometryEstimate estimate(profile);
    Observation o = at_rest(48.0, 43.0);
    o.needle.emplace();
    o.needle->tip_radius_um = 0.25 * profile.tip_radius_um;
    o.needle->tip_radius_sigma = sigma;
    estimate.update(o);
    EXPECT_NEAR(estimate.geometry().tip_radius_um, 0.25 * profile.tip_radius_um, 1e-9) << sigma;
    EXPECT_NEAR(estimate.log_sigmas()[1], sigma, 1e-9);
    EXPECT_GT(estimate.force_sigma_ratio(), last_sigma) << sigma;
    last_sigma = estimate.force_sigma_ratio();
  }
}

}  // namespace
}  // namespace pellucida
