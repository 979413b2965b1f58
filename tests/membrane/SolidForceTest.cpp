// The solid's force in place of the springs': where, how much, and without a step.
#include "pellucida/membrane/SolidForce.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

Eigen::Vector3d direction(double angle_deg) {
  const double angle = angle_deg * std::acos(-1.0) / 180.0;
  return {std::sin(angle), 0.0, -std::cos(angle)};
}

class ShippedSolid : public ::testing::TestWithParam<const char*> {
 protected:
  /// With the holder so far from opposite the needle.
  Indenter indenter(const CellProfile& profile, const MembraneGeometry& geometry, double angle_deg = 0.0) {
    return Indenter(profile, geometry, -Eigen::Vector3d::UnitZ(), direction(angle_deg));
  }

  CellProfile profile_ = load_profile(GetParam());
  CellProfile springs_ = [this] {
    CellProfile springs = profile_;
    springs.geometry_range.solid_force_ratio = 0.0;
    return springs;
  }();
  MembraneGeometry seen_{46.0, 9.0, 1.1, 26.0};
};

TEST_P(ShippedSolid, ItsScaleIsThatOfTheProfilesOwnCellAtThePuncture) {
  EXPECT_NEAR(solid_force_ratio(profile_) / profile_.geometry_range.solid_force_ratio, 1.0, 1e-5);
  const auto solid = SolidForce::of(profile_, geometry_of(profile_));
  ASSERT_TRUE(solid);
  EXPECT_NEAR(std::exp(solid->at(profile_.puncture_indentation_um).log_uN), profile_.puncture_force_uN,
              1e-3 * profile_.puncture_force_uN);
}

// Its polynomials leave some per cent there, the springs with their terms are that very cell's.
TEST_P(ShippedSolid, TheProfilesOwnCellHasItsSprings) {
  const auto solid = SolidForce::of(profile_, geometry_of(profile_));
  ASSERT_TRUE(solid);
  const auto both = force_curve(profile_, 1, 44.0, 4.0), springs = force_curve(springs_, 1, 44.0, 4.0);
  for (std::size_t k = 1; k < both.size(); ++k) {
    EXPECT_EQ(both[k].push_force_uN, springs[k].push_force_uN);
    EXPECT_NEAR(std::exp(solid->at(both[k].depth_um).log_uN), springs[k].push_force_uN, 0.06 * springs[k].push_force_uN)
        << both[k].depth_um << " um";
  }
  MembraneGeometry near = geometry_of(profile_);
  near.thickness_um *= 1.15;
  EXPECT_NEAR(indenter(profile_, near).solid_share(), 0.5, 0.1);
}

TEST_P(ShippedSolid, OtherCellsBearWhatTheSolidDoes) {
  Indenter other = indenter(profile_, seen_);
  EXPECT_EQ(other.solid_share(), 1.0);
  const auto solid = SolidForce::of(profile_, seen_);
  ASSERT_TRUE(solid);
  for (const double depth_um : {0.5, 8.0, 30.0}) {
    const IndentationState state = other.advance_to(depth_um);
    const double force_uN = std::exp(solid->at(depth_um).log_uN);
    EXPECT_NEAR(state.push_force_uN, force_uN, 1e-9 * force_uN);
    EXPECT_NEAR(state.stiffness_uN_per_um, solid->at(depth_um).by_depth_per_um * force_uN, 1e-6 * force_uN);
  }
}

TEST_P(ShippedSolid, AtTheTouchTheStiffnessIsTheForcesSlope) {
  Indenter other = indenter(profile_, seen_);
  const double at_rest = other.advance_to(0.0).stiffness_uN_per_um;
  const IndentationState touch = other.advance_to(0.02);
  EXPECT_NEAR(at_rest, touch.push_force_uN / 0.02, 0.01 * at_rest);
  EXPECT_NEAR(at_rest, touch.stiffness_uN_per_um, 0.02 * at_rest);
}

TEST_P(ShippedSolid, TheForceGoesOverToTheSpringsAsTheNeedleTurns) {
  const double depth_um = 20.0;
  const auto force_uN = [&](const CellProfile& profile, double angle_deg) {
    return indenter(profile, seen_, angle_deg).advance_to(depth_um).push_force_uN;
  };
  double last = force_uN(profile_, 0.0) / force_uN(springs_, 0.0);
  const double whole = last;
  EXPECT_GT(std::abs(whole - 1.0), 1e-3);
  EXPECT_NEAR(force_uN(profile_, 9.0) / force_uN(profile_, 0.0), 1.0, 1e-9);
  for (const double angle_deg : {13.0, 19.0, 26.0}) {
    const double ratio = force_uN(profile_, angle_deg) / force_uN(springs_, angle_deg);
    EXPECT_LE(std::abs(std::log(ratio)), std::abs(std::log(last)) + 0.02) << angle_deg;
    last = ratio;
  }
  EXPECT_EQ(last, 1.0);
}

TEST_P(ShippedSolid, OutsideItsRangeTheSpringsBear) {
  MembraneGeometry finest = seen_;
  finest.tip_radius_um = 0.1;
  EXPECT_FALSE(SolidForce::of(profile_, finest));
  EXPECT_FALSE(SolidForce::of(springs_, seen_));
  EXPECT_EQ(indenter(profile_, finest).solid_share(), 0.0);
  EXPECT_EQ(indenter(profile_, finest).advance_to(12.0).push_force_uN,
            indenter(springs_, finest).advance_to(12.0).push_force_uN);
}

TEST_P(ShippedSolid, LiquidThatLeavesFreelyIsNotTheSolids) {
  const auto solid = SolidForce::of(profile_, seen_);
  ASSERT_TRUE(solid);
  MembraneSetup setup{seen_.mid_radius_um, seen_.thickness_um};
  EXPECT_EQ(solid->share(setup), 1.0);
  setup.keeps_volume = false;
  EXPECT_EQ(solid->share(setup), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Profiles, ShippedSolid, ::testing::Values("mouse-oocyte", "mouse-embryo"),
                         [](const auto& which) { return std::string(which.param).substr(6); });

}  // namespace
}  // namespace pellucida
