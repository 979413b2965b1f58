#include "pellucida/membrane/MembraneGeometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

double force_at_uN(const CellProfile& profile, const MembraneGeometry& geometry, double depth_um) {
  const MembraneSetup setup{geometry.mid_radius_um, geometry.thickness_um};
  return force_curve(profile, geometry, setup, depth_um, depth_um).back().push_force_uN;
}

class ShippedGeometry : public ::testing::TestWithParam<const char*> {
 protected:
  CellProfile profile_ = load_profile(GetParam());
  MembraneGeometry own_ = geometry_of(profile_);
};

TEST_P(ShippedGeometry, TheProfilesOwnIsCorrectedByTheDepthAlone) {
  EXPECT_EQ(to_json(adapted_to(profile_, own_)), to_json(profile_));
  // 1 where the modulus was set; the thin shell is too weak above, most at the surface, where it stays within a
  // quarter.
  EXPECT_NEAR(geometry_factor(profile_, own_, profile_.puncture_indentation_um).ratio, 1.0, 1e-9);
  for (const auto& [depth_um, least, most] :
       {std::tuple{0.0, 1.1, 1.3}, {6.0, 1.12, 1.25}, {15.0, 1.02, 1.12}, {30.0, 1.0, 1.06}}) {
    EXPECT_GT(geometry_factor(profile_, own_, depth_um).ratio, least) << depth_um;
    EXPECT_LT(geometry_factor(profile_, own_, depth_um).ratio, most) << depth_um;
  }
  profile_.geometry_range.solid_force_ratio = 0.0;  // the springs alone
  const auto springs = force_curve(profile_, setup_for_configuration(profile_, 1), 30.0, 15.0);
  EXPECT_DOUBLE_EQ(force_at_uN(profile_, own_, 15.0),
                   geometry_factor(profile_, own_, 15.0).ratio * springs[1].push_force_uN);
  EXPECT_EQ(force_curve(profile_, 1, 30.0, 15.0)[1].push_force_uN, force_at_uN(profile_, own_, 15.0));

  // The sizes' terms vanish there.
  for (auto* terms : {&profile_.geometry_terms, &profile_.geometry_pressure_terms})
    std::erase_if(*terms, [](const GeometryTerm& t) { return t.thickness + t.tip + t.holder == 0; });
  for (const double depth_um : {0.0, 7.0, 44.0, 70.0}) {
    const GeometryFactor factor = geometry_factor(profile_, own_, depth_um);
    EXPECT_EQ(factor.ratio, 1.0);
    EXPECT_EQ(factor.slope_per_um, 0.0);
    EXPECT_EQ(pressure_factor(profile_, own_, depth_um), 1.0);
  }
}

TEST_P(ShippedGeometry, AllLengthsTimesTwoIsTheForceTimesFour) {
  const MembraneGeometry seen{46.0, 7.0, 3.1, 26.0}, twice{92.0, 14.0, 6.2, 52.0};
  for (const double depth_um : {8.0, 30.0})
    EXPECT_NEAR(force_at_uN(profile_, twice, 2 * depth_um), 4 * force_at_uN(profile_, seen, depth_um),
                4e-3 * force_at_uN(profile_, seen, depth_um));
}

TEST_P(ShippedGeometry, SlopeIsTheDerivative) {
  const MembraneGeometry seen{52.0, 9.0, 1.3, 31.0};
  for (const double depth_um : {1.0, 20.0, 45.0}) {
    const double step_um = 1e-4;
    const double by_difference = (geometry_factor(profile_, seen, depth_um + step_um).ratio -
                                  geometry_factor(profile_, seen, depth_um - step_um).ratio) /
                                 (2 * step_um);
    EXPECT_NEAR(geometry_factor(profile_, seen, depth_um).slope_per_um, by_difference, 1e-7);
  }
  // The stiffness is that of the force as it is reported.
  Indenter indenter(profile_, seen, -Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitZ());
  const double before_uN = indenter.advance_to(19.99).push_force_uN;
  const double stiffness_uN_per_um = indenter.advance_to(20.0).stiffness_uN_per_um;
  const double after_uN = indenter.advance_to(20.01).push_force_uN;
  EXPECT_NEAR(stiffness_uN_per_um, (after_uN - before_uN) / 0.02, 1e-3 * stiffness_uN_per_um);
}

TEST_P(ShippedGeometry, BeyondTheRangeTheFactorStays) {
  MembraneGeometry finest = own_, finer = own_;
  finest.tip_radius_um = profile_.geometry_range.tip_from_ratio * own_.mid_radius_um;
  finer.tip_radius_um = 0.5 * finest.tip_radius_um;
  EXPECT_FALSE(is_beyond_range(profile_, own_));
  EXPECT_TRUE(is_beyond_range(profile_, finer));
  EXPECT_EQ(geometry_factor(profile_, finer, 20.0).ratio, geometry_factor(profile_, finest, 20.0).ratio);
  const double deepest_um = profile_.geometry_range.depth_to_ratio * own_.mid_radius_um;
  EXPECT_EQ(geometry_factor(profile_, finest, deepest_um + 5).ratio,
            geometry_factor(profile_, finest, deepest_um).ratio);
  EXPECT_EQ(geometry_factor(profile_, finest, deepest_um + 5).slope_per_um, 0.0);
}

// A thick wall yields under the needle by itself; the liquid is pressed less than the needle's force says.
TEST_P(ShippedGeometry, ThePressureFallsBehindTheForceOfAThickWall) {
  MembraneGeometry thick = own_;
  thick.thickness_um *= 2.0;
  // The embryo's have not been fitted.
  if (!profile_.geometry_pressure_terms.empty()) {
    EXPECT_LT(pressure_factor(profile_, thick, 15.0), 0.9 * geometry_factor(profile_, thick, 15.0).ratio);
  }
  profile_.geometry_pressure_terms.clear();
  EXPECT_EQ(pressure_factor(profile_, thick, 15.0), geometry_factor(profile_, thick, 15.0).ratio);
}

INSTANTIATE_TEST_SUITE_P(Profiles, ShippedGeometry, ::testing::Values("mouse-oocyte", "mouse-embryo"),
                         [](const auto& which) { return std::string(which.param).substr(6); });

TEST(MembraneGeometry, WithoutTermsTheFactorIsOne) {
  CellProfile profile = load_profile("mouse-oocyte");
  profile.geometry_terms.clear();
  profile.geometry_pressure_terms.clear();
  EXPECT_EQ(pressure_factor(profile, {40.0, 12.0, 1.0, 30.0}, 20.0), 1.0);
  EXPECT_EQ(geometry_factor(profile, {40.0, 12.0, 1.0, 30.0}, 20.0).ratio, 1.0);
  EXPECT_FALSE(is_beyond_range(profile, {40.0, 39.0, 1.0, 30.0}));
}

}  // namespace
}  // namespace pellucida
