#include "pellucida/haptics/Fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace pellucida {
namespace {

using Vector = Eigen::Vector3d;
constexpr double kScale_um_per_m = 2000.0;

// A cell of radius 40 at (100, 100), entered from the left along +x, held from the right.
FixtureSet all_fixtures() {
  FixtureSet set;
  set.guide.enabled = set.cone.enabled = set.stop.enabled = set.cell.enabled = set.holder.enabled = true;
  set.guide.entry_um = set.cone.entry_um = set.stop.entry_um = set.cell.entry_um = Vector(60.0, 100.0, 0.0);
  set.stop.depth_um = 40.0;
  set.cell.center_um = Vector(100.0, 100.0, 0.0);
  set.cell.radius_um = 40.0;
  set.holder.mouth_um = Vector(140.0, 100.0, 0.0);
  set.holder.direction = Vector(1.0, 0.0, 0.0);
  set.holder.radius_um = 50.0;
  return set;
}

Vector still(const FixtureSet& set, const Vector& tip_um) {
  return apply(set, tip_um, Vector::Zero(), kScale_um_per_m, 1.0).force_N;
}

TEST(Fixtures, OnThePathNothingIsFelt) {
  const FixtureSet set = all_fixtures();
  for (double x = -40.0; x <= 100.0; x += 0.5) {
    for (const double across : {0.0, 0.5, -0.9}) {
      const FixtureResult result = apply(set, Vector(x, 100.0, across), Vector(50.0, 0.0, 0.0), kScale_um_per_m, 1.0);
      EXPECT_EQ(result.acting, 0U) << x;
      EXPECT_EQ(result.force_N.norm(), 0.0) << x;
    }
  }
}

TEST(Fixtures, TheGuideLeadsInsertionAndRemovalStraight) {
  FixtureSet set;
  set.guide = all_fixtures().guide;
  // 9 um beside the line: 8 beyond the play, less half the width.
  for (const double x : {60.0, 80.0, 100.0}) {
    const FixtureResult result = apply(set, Vector(x, 109.0, 0.0), Vector::Zero(), kScale_um_per_m, 1.0);
    EXPECT_EQ(result.acting, static_cast<std::uint32_t>(kGuideBit));
    EXPECT_NEAR(result.allowed_um.y(), 102.0, 1e-9);
    EXPECT_NEAR(result.force_N.y(), -7.0 / kScale_um_per_m * set.guide.feel.stiffness_N_per_m, 1e-9);
    EXPECT_NEAR(result.force_N.x(), 0.0, 1e-12) << "free along the line";
  }
}

TEST(Fixtures, TheConeFunnelsToTheEntry) {
  FixtureSet set;
  set.cone = all_fixtures().cone;
  // 50 um before the entry the funnel is 1 + (15 + 20) tan 0.3 = 12 um wide.
  EXPECT_EQ(still(set, Vector(10.0, 110.0, 0.0)).norm(), 0.0);
  const Vector force = still(set, Vector(10.0, 130.0, 0.0));
  EXPECT_LT(force.y(), 0.0);
  EXPECT_LT(force.x(), 0.0) << "out of the funnel's wall, away from the cell";
  EXPECT_EQ(still(set, Vector(-200.0, 130.0, 0.0)).norm(), 0.0) << "far away nothing is felt";
}

TEST(Fixtures, TheDepthStopHoldsThePipette) {
  FixtureSet set;
  set.stop = all_fixtures().stop;
  EXPECT_EQ(still(set, Vector(100.0, 100.0, 0.0)).norm(), 0.0);
  const FixtureResult result = apply(set, Vector(120.0, 100.0, 0.0), Vector::Zero(), kScale_um_per_m, 1.0);
  EXPECT_NEAR(result.allowed_um.x(), 100.0 + 0.5 * set.stop.feel.width_um, 1e-9);
}

TEST(Fixtures, ForbiddenBodiesAreLeftTheShortWay) {
  FixtureSet set;
  set.cell = all_fixtures().cell;
  const FixtureResult side = apply(set, Vector(100.0, 136.0, 0.0), Vector::Zero(), kScale_um_per_m, 1.0);
  EXPECT_GT(side.allowed_um.y(), 138.0) << "out of the cell";
  const FixtureResult inside = apply(set, Vector(100.0, 109.0, 0.0), Vector::Zero(), kScale_um_per_m, 1.0);
  EXPECT_LT(inside.allowed_um.y(), 107.5) << "back into the path";
  EXPECT_EQ(still(set, Vector(100.0, 104.0, 0.0)).norm(), 0.0) << "in the path";

  set = FixtureSet{};
  set.holder = all_fixtures().holder;
  const FixtureResult front = apply(set, Vector(145.0, 100.0, 0.0), Vector::Zero(), kScale_um_per_m, 1.0);
  EXPECT_LT(front.allowed_um.x(), 141.5);
  const FixtureResult beside = apply(set, Vector(200.0, 145.0, 0.0), Vector::Zero(), kScale_um_per_m, 1.0);
  EXPECT_GT(beside.allowed_um.y(), 148.0);
}

// Along random lines the force changes in proportion to the way: no step anywhere, and a slope that the stiffness
// bounds.
void expect_continuous(const FixtureSet& set, double stiffest_N_per_m, const char* name) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-60.0, 260.0), side(-10.0, 10.0);
  constexpr double kStep_um = 0.01;
  for (int line = 0; line < 400; ++line) {
    Vector tip(place(random), place(random), side(random) * (line % 2));
    Vector way(side(random), side(random), side(random) * (line % 2));
    if (way.norm() < 1e-3) continue;
    way *= kStep_um / way.norm();
    Vector last = still(set, tip);
    for (int k = 0; k < 3000; ++k) {
      tip += way;
      const Vector force = still(set, tip);
      ASSERT_TRUE(force.allFinite()) << name;
      ASSERT_LE((force - last).norm(), stiffest_N_per_m * kStep_um / kScale_um_per_m)
          << name << " at " << tip.transpose() << " line " << line;
      last = force;
    }
  }
}

TEST(Fixtures, EachOneIsContinuousEverywhere) {
  const FixtureSet all = all_fixtures();
  const auto alone = [&](const char* name, const std::function<void(FixtureSet&)>& choose) {
    FixtureSet set;
    choose(set);
    // Beside a curved boundary a long correction turns as the tip moves along it: stiffer than the fixture's own 200
    // N/m, within what its largest force allows.
    expect_continuous(set, 3.5 * 200.0, name);
  };
  alone("guide", [&](FixtureSet& set) { set.guide = all.guide; });
  alone("cone", [&](FixtureSet& set) { set.cone = all.cone; });
  alone("stop", [&](FixtureSet& set) { set.stop = all.stop; });
  alone("cell", [&](FixtureSet& set) { set.cell = all.cell; });
  alone("holder", [&](FixtureSet& set) { set.holder = all.holder; });
}

TEST(Fixtures, TogetherTheyAreLimitedAndContinuous) {
  FixtureSet set = all_fixtures();
  set.max_force_N = 0.8;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-100.0, 300.0), speed(-2000.0, 2000.0);
  for (int k = 0; k < 20000; ++k) {
    const Vector tip(place(random), place(random), place(random) - 100.0);
    const Vector velocity(speed(random), speed(random), speed(random));
    const FixtureResult result = apply(set, tip, velocity, kScale_um_per_m, 1.0);
    ASSERT_LE(result.force_N.norm(), 0.8 + 1e-12);
    ASSERT_TRUE(result.allowed_um.allFinite());
  }
  set.max_force_N = 2.0;
  expect_continuous(set, 6.0 * 200.0, "all");
}

TEST(Fixtures, TwoThatWantTheSameDoNotPushTwice) {
  FixtureSet set;
  set.guide = all_fixtures().guide;
  const double guide_alone_N = still(set, Vector(80.0, 115.0, 0.0)).norm();
  set.cell = all_fixtures().cell;
  set.cell.path_radius_um = 3.0;
  const double both_N = still(set, Vector(80.0, 115.0, 0.0)).norm();
  EXPECT_LT(both_N, 1.1 * guide_alone_N);
}

TEST(Fixtures, DampingWorksOnlyWhereTheFixtureActs) {
  FixtureSet set;
  set.stop = all_fixtures().stop;
  const Vector inside(90.0, 100.0, 0.0), beyond(110.0, 100.0, 0.0), velocity(500.0, 0.0, 0.0);
  EXPECT_EQ(apply(set, inside, velocity, kScale_um_per_m, 1.0).force_N.norm(), 0.0);
  const double still_N = apply(set, beyond, Vector::Zero(), kScale_um_per_m, 1.0).force_N.x();
  const double moving_N = apply(set, beyond, velocity, kScale_um_per_m, 1.0).force_N.x();
  EXPECT_NEAR(moving_N - still_N, -set.stop.feel.damping_N_s_per_m * 500.0 / kScale_um_per_m, 1e-9);
}

TEST(Fixtures, FadedOutTheyDoNothing) {
  const FixtureSet set = all_fixtures();
  const FixtureResult result = apply(set, Vector(100.0, 130.0, 0.0), Vector::Zero(), kScale_um_per_m, 0.0);
  EXPECT_EQ(result.acting, 0U);
  EXPECT_EQ(result.allowed_um, Vector(100.0, 130.0, 0.0));
}

}  // namespace
}  // namespace pellucida
