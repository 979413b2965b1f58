#include "pellucida/mechanics/ForceObserver.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/MembraneGeometry.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

/// A cell of 52.5 um at (200, 150) um, held on one side, with the needle in direction `axis_rad` from its centre.
Observation make_observation(CellState state, double depth_um, double axis_rad, double holder_rad, long frame) {
  Observation o;
  o.time_s = static_cast<double>(frame) / 30.0;
  o.frame_index = frame;
  o.state = state;
  o.confidence = 1.0;
  o.center_um = {200.0, 150.0};
  o.rest_outer_radius_um = 52.5;
  o.rest_inner_radius_um = 47.5;
  o.outer.emplace();
  o.axis = {std::cos(axis_rad), std::sin(axis_rad)};
  o.needle = NeedlePose{o.center_um + (52.5 - depth_um) * o.axis, -o.axis, 5.0, 1.0, {}};
  HolderPose holder;
  holder.direction = {std::cos(holder_rad), std::sin(holder_rad)};
  o.holder = holder;
  o.indentation_um = depth_um;
  o.indentation_sigma_um = 0.15;
  return o;
}

/// Ramps to `depth_um` in steps of a frame and gives the last estimate.
ForceEstimate ramp(ForceObserver& observer, double depth_um, double axis_rad, double holder_rad) {
  ForceEstimate estimate;
  const int frames = static_cast<int>(std::ceil(depth_um / 0.7));
  for (int frame = 0; frame <= frames; ++frame) {
    const double depth = depth_um * frame / frames;
    estimate = observer.process(
        make_observation(depth > 0.0 ? CellState::kContact : CellState::kFree, depth, axis_rad, holder_rad, frame));
    EXPECT_TRUE(estimate.converged) << depth << " " << estimate.reason;
  }
  return estimate;
}

void expect_finite(const ForceEstimate& e) {
  EXPECT_TRUE(e.rest_um.allFinite() && e.solved_um.allFinite() && e.force_uN.allFinite());
  EXPECT_TRUE(e.force_sigma_uN.allFinite() && e.tension_uN_per_um.allFinite() &&
              e.tension_sigma_uN_per_um.allFinite() && e.tip_force_uN.allFinite());
}

TEST(ForceObserver, MeetsTheForceCurveAtAnyAngleInTheImage) {
  const CellProfile profile = load_profile("mouse-oocyte");
  for (const int configuration : {1, 2, 3}) {
    const auto curve = force_curve(profile, configuration, 30.0, 1.0);
    for (const double axis : {0.0, 1.1, -2.4}) {
      ForceObserver observer(profile);
      const double holder = axis + std::numbers::pi - 0.25 * std::numbers::pi * (configuration - 1);
      const ForceEstimate e = ramp(observer, 30.0, axis, holder);
      EXPECT_NEAR(e.contact_force_uN, curve.back().push_force_uN, 3e-5 * curve.back().push_force_uN);
      EXPECT_LT(e.contact_force_lower_uN, e.contact_force_uN);
      EXPECT_GT(e.contact_force_upper_uN, e.contact_force_uN);
      EXPECT_FALSE(e.holder_assumed);
      // The needle pushes against the axis, in the image plane.
      EXPECT_NEAR(e.tip_force_uN.dot(Eigen::Vector3d(-std::cos(axis), -std::sin(axis), 0.0)), e.contact_force_uN, 1e-9);
      EXPECT_NEAR(e.tip_force_uN.z(), 0.0, 1e-9 * e.contact_force_uN);
      expect_finite(e);
    }
  }
}

// The dimple of a thick, small cell gives way before the needle is 1.4 radii deep: said once the model was solved that
// far, without solving again, and forgotten when the needle is back.
TEST(ForceObserver, BeyondTheDeepestEquilibriumThereIsNoForceAndNoSolving) {
  const CellProfile profile = load_profile("mouse-embryo");
  ForceObserver observer(profile);
  const auto at = [&](double depth_um, long frame) {
    Observation o = make_observation(CellState::kContact, depth_um, 0.0, std::numbers::pi, frame);
    o.rest_outer_radius_um = 41.0;
    o.rest_inner_radius_um = 37.0;
    o.needle->tip_um = o.center_um + (41.0 - depth_um) * o.axis;
    return observer.process(o);
  };
  long frame = 0;
  ForceEstimate before;
  for (double depth_um = 1.0; depth_um < 38.0; depth_um += 1.0) before = at(depth_um, frame++);
  ASSERT_TRUE(before.converged) << before.reason;
  for (double depth_um = 39.0; depth_um < 50.0; depth_um += 1.0) at(depth_um, frame++);
  for (int again = 0; again < 3; ++again) {
    const ForceEstimate beyond = at(50.0, frame++);
    EXPECT_FALSE(beyond.converged);
    EXPECT_EQ(beyond.reason, "the model found no equilibrium: the shape is unstable");
    EXPECT_EQ(beyond.iterations, 0);
  }
  for (int back = 0; back < 30; ++back) at(37.0, frame++);
  const ForceEstimate after = at(37.0, frame++);
  EXPECT_TRUE(after.converged) << after.reason;
  EXPECT_NEAR(after.contact_force_uN, before.contact_force_uN, 0.02 * before.contact_force_uN);
}

TEST(ForceObserver, NodesLieOnTheCellAndTheirForcesBalance) {
  ForceObserver observer(load_profile("mouse-oocyte"));
  const ForceEstimate e = ramp(observer, 20.0, 0.5, 0.5 + std::numbers::pi);
  EXPECT_LT(((e.rest_um.colwise() - Eigen::Vector3d(200, 150, 0)).colwise().norm().array() - 50.0).abs().maxCoeff(),
            1e-9);
  EXPECT_LT(e.force_uN.rowwise().sum().norm(), 1e-9 * e.contact_force_uN);
  EXPECT_NEAR(e.rotation_WC.determinant(), 1.0, 1e-12);

  // The apex went in by the depth observed.
  Eigen::Index apex = 0;
  const Eigen::Vector3d axis(std::cos(0.5), std::sin(0.5), 0.0);
  (axis.transpose() * (e.rest_um.colwise() - Eigen::Vector3d(200, 150, 0))).maxCoeff(&apex);
  EXPECT_NEAR((e.rest_um.col(apex) - e.solved_um.col(apex)).dot(axis), 20.0, 0.023);
  // Under the tip (a patch of 5 um, and a triangle's edge beyond) the membrane pushes back at the needle, with the
  // whole force but the pressure's part.
  const Eigen::Vector3d pole = Eigen::Vector3d(200, 150, 0) + 50.0 * axis;
  Eigen::Vector3d under_tip = Eigen::Vector3d::Zero();
  for (Eigen::Index n = 0; n < e.rest_um.cols(); ++n) {
    if ((e.rest_um.col(n) - pole).norm() < 11.5) under_tip += e.force_uN.col(n);
  }
  EXPECT_NEAR(under_tip.dot(axis), e.contact_force_uN, 0.12 * e.contact_force_uN);
  // The mesh is a closed surface, outward in W as well.
  EXPECT_GT(enclosed_volume_um3(e.solved_um.colwise() - Eigen::Vector3d(200, 150, 0), e.triangles), 0.0);
  EXPECT_NEAR(e.volume_um3, 4.0 / 3.0 * std::numbers::pi * std::pow(52.5, 3), 7e-5 * e.volume_um3);
}

TEST(ForceObserver, StatesWithoutContactGiveZeroOrNothing) {
  ForceObserver observer(testing::coarse_profile());
  Observation away = make_observation(CellState::kFree, 0.0, 0.0, std::numbers::pi, 0);
  away.needle->tip_um -= 5.0 * away.needle->direction;
  const ForceEstimate free = observer.process(away);
  EXPECT_DOUBLE_EQ(free.contact_force_uN, 0.0);
  EXPECT_DOUBLE_EQ(free.contact_force_upper_uN, 0.0);
  EXPECT_TRUE(free.converged);
  EXPECT_LT(free.force_uN.cwiseAbs().maxCoeff(), 1e-9);

  const ForceEstimate contact = ramp(observer, 15.0, 0.0, std::numbers::pi);
  EXPECT_GT(contact.contact_force_uN, 0.5);
  // The tip goes on into the cell, the membrane has come back.
  Observation through = make_observation(CellState::kPunctured, 18.0, 0.0, std::numbers::pi, 23);
  through.indentation_um = 2.0;
  const ForceEstimate punctured = observer.process(through);
  EXPECT_DOUBLE_EQ(punctured.contact_force_uN, 0.0);
  EXPECT_DOUBLE_EQ(punctured.pressure_Pa, 0.0);

  for (const CellState state : {CellState::kNoCell, CellState::kLost}) {
    const ForceEstimate nothing = observer.process(make_observation(state, 10.0, 0.0, std::numbers::pi, 61));
    EXPECT_TRUE(std::isnan(nothing.contact_force_uN));
    EXPECT_FALSE(nothing.converged);
    EXPECT_FALSE(nothing.reason.empty());
    EXPECT_EQ(nothing.rest_um.cols(), 0);
  }
}

TEST(ForceObserver, APushedDimpleIsAContactWhateverWasTracked) {
  ForceEstimate estimate;
  EXPECT_EQ(estimate.judged_state(CellState::kPunctured), CellState::kPunctured);
  estimate.flanks_pushed = true;
  EXPECT_EQ(estimate.judged_state(CellState::kPunctured), CellState::kContact);
  estimate.punctured = true;
  EXPECT_EQ(estimate.judged_state(CellState::kContact), CellState::kPunctured);
}

// A tip lost in the cell's texture looks to the tracker as if it were far past the membrane.
TEST(ForceObserver, APunctureThatTheMembraneDoesNotBearOutIsAContactInDoubt) {
  ForceObserver observer(testing::coarse_profile());
  const ForceEstimate before = ramp(observer, 15.0, 0.0, std::numbers::pi);
  Observation ahead = make_observation(CellState::kPunctured, 23.0, 0.0, std::numbers::pi, 23);
  ahead.indentation_um = 15.5;
  const ForceEstimate e = observer.process(ahead);
  EXPECT_FALSE(e.punctured);
  EXPECT_FALSE(e.puncture);
  EXPECT_TRUE(e.puncture_doubted);
  EXPECT_EQ(e.judged_state(ahead.state), CellState::kContact);
  EXPECT_GT(e.contact_force_uN, before.contact_force_uN);
  EXPECT_GT(e.errors.depth_uN, 2.0 * before.errors.depth_uN);
  // Either may be right: the interval holds the force at both depths.
  EXPECT_LT(e.by_picture.lower_uN, before.contact_force_uN);
  EXPECT_TRUE(e.warnings & kNeedleSlip);
}

// A contour with a spike far beyond the tip, or a tip that is lost for a frame, carries no force of its own.
TEST(ForceObserver, OfTipAndMembraneFarApartTheOneCountsThatGoesOnAsBefore) {
  const auto after_ramp = [](double tip_um, double membrane_um) {
    ForceObserver observer(testing::coarse_profile());
    ramp(observer, 15.0, 0.0, std::numbers::pi);
    Observation o = make_observation(CellState::kContact, tip_um, 0.0, std::numbers::pi, 23);
    o.indentation_um = membrane_um;
    return observer.process(o);
  };
  const ForceEstimate together = after_ramp(15.7, 15.7), spike = after_ramp(15.7, 30.0), lost = after_ramp(33.0, 15.7);
  for (const ForceEstimate& apart : {spike, lost}) {
    EXPECT_NEAR(apart.contact_force_uN, together.contact_force_uN, 0.05 * together.contact_force_uN);
    EXPECT_GT(apart.errors.depth_uN, 5.0 * together.errors.depth_uN);
  }
}

TEST(ForceObserver, FewCellsBearSuchAForceIsAWarning) {
  const CellProfile profile = testing::coarse_profile();
  ForceObserver observer(profile);
  const ForceEstimate usual = ramp(observer, 0.8 * profile.puncture_indentation_um, 0.0, std::numbers::pi);
  EXPECT_FALSE(usual.warnings & kSeldomBorne);
  observer.reset();
  const ForceEstimate deep = ramp(observer, 1.25 * profile.puncture_indentation_um, 0.0, std::numbers::pi);
  ASSERT_GT(deep.contact_force_uN, 1.35 * profile.puncture_force_uN);
  EXPECT_TRUE(deep.warnings & kSeldomBorne);
  EXPECT_NE(describe(deep.warnings, profile.name).find(profile.name), std::string::npos);
}

/// The force 20 um deep in a cell of a zona, a tip and a holder that were seen while the needle was free.
ForceEstimate of_sizes(const CellProfile& profile, double thickness_um, double tip_radius_um, double holder_radius_um) {
  ForceObserver observer(profile);
  ForceEstimate estimate;
  for (int frame = 0; frame <= 40; ++frame) {
    const double depth_um = std::max(0.0, frame - 20.0);
    Observation o = make_observation(depth_um > 0.0 ? CellState::kContact : CellState::kFree, depth_um, 0.0,
                                     std::numbers::pi, frame);
    o.rest_inner_radius_um = o.rest_outer_radius_um - thickness_um;
    // In the dimple a tracker may take anything for the tip's width.
    o.needle->tip_radius_um = depth_um > 0.0 ? 3.0 * tip_radius_um : tip_radius_um;
    o.holder->outer_radius_um = holder_radius_um;
    estimate = observer.process(o);
    EXPECT_TRUE(estimate.converged) << estimate.reason;
  }
  return estimate;
}

TEST(ForceObserver, SizesThatAreSeenDecideTheForce) {
  const CellProfile profile = load_profile("mouse-oocyte");
  const ForceEstimate usual = of_sizes(profile, 5.0, 5.0, 22.5);
  const auto force_of = [&](double thickness_um, double tip_radius_um, double holder_radius_um) {
    const MembraneGeometry geometry{52.5 - 0.5 * thickness_um, thickness_um, tip_radius_um, holder_radius_um};
    return force_curve(profile, geometry, {geometry.mid_radius_um, thickness_um}, 20.0, 20.0).back().push_force_uN;
  };
  EXPECT_NEAR(usual.contact_force_uN, force_of(5.0, 5.0, 22.5), 0.01 * usual.contact_force_uN);
  const struct {
    double thickness_um, tip_radius_um, holder_radius_um;
  } cells[] = {{8.0, 5.0, 22.5}, {5.0, 2.0, 22.5}, {5.0, 5.0, 33.0}, {3.0, 1.5, 15.0}};
  for (const auto& cell : cells) {
    SCOPED_TRACE(::testing::Message() << cell.thickness_um << ' ' << cell.tip_radius_um << ' '
                                      << cell.holder_radius_um);
    const double expected_uN = force_of(cell.thickness_um, cell.tip_radius_um, cell.holder_radius_um);
    const ForceEstimate seen = of_sizes(profile, cell.thickness_um, cell.tip_radius_um, cell.holder_radius_um);
    EXPECT_NEAR(seen.contact_force_uN, expected_uN, 0.02 * expected_uN);
    EXPECT_GT(std::abs(seen.contact_force_uN - usual.contact_force_uN), 0.05 * usual.contact_force_uN);
  }
  // And what isn't seen is not sure.
  const ForceEstimate unseen = of_sizes(profile, 5.0, 0.0, 0.0);
  EXPECT_GT(unseen.errors.geometry_ratio, 1.7 * usual.errors.geometry_ratio);
}

TEST(ForceObserver, MissingPartsAreSaidNotGuessed) {
  ForceObserver observer(testing::coarse_profile());
  Observation o = make_observation(CellState::kContact, 5.0, 0.0, std::numbers::pi, 0);
  o.holder.reset();
  o.rest_inner_radius_um = 0.0;
  const ForceEstimate assumed = observer.process(o);
  EXPECT_TRUE(assumed.converged);
  EXPECT_TRUE(assumed.holder_assumed);
  EXPECT_TRUE(assumed.thickness_assumed);
  EXPECT_GT(assumed.contact_force_uN, 0.0);

  o.needle.reset();
  const ForceEstimate blind = observer.process(o);
  EXPECT_TRUE(std::isnan(blind.contact_force_uN));
  EXPECT_FALSE(blind.reason.empty());

  o = make_observation(CellState::kContact, 5.0, 0.0, std::numbers::pi, 2);
  o.indentation_um = std::nan("");
  EXPECT_TRUE(std::isnan(observer.process(o).contact_force_uN));
  o.indentation_um = 1e6;
  EXPECT_TRUE(std::isnan(observer.process(o).contact_force_uN));
  o = make_observation(CellState::kContact, 5.0, 0.0, std::numbers::pi, 3);
  o.rest_outer_radius_um = 0.0;
  EXPECT_TRUE(std::isnan(observer.process(o).contact_force_uN));

  // A cell of another kind, or a wrong pixel size.
  o = make_observation(CellState::kContact, 1.0, 0.0, std::numbers::pi, 3);
  o.rest_outer_radius_um = 4.0;
  o.rest_inner_radius_um = 0.0;
  const ForceEstimate tiny = observer.process(o);
  EXPECT_TRUE(std::isnan(tiny.contact_force_uN));
  EXPECT_NE(tiny.reason.find("radius is 4 um"), std::string::npos) << tiny.reason;

  // And it recovers.
  const ForceEstimate again = observer.process(make_observation(CellState::kContact, 5.0, 0.0, std::numbers::pi, 4));
  EXPECT_TRUE(again.converged);
  expect_finite(again);
}

TEST(ForceObserver, ANoisierDepthWidensTheInterval) {
  ForceObserver sharp(testing::coarse_profile()), blurred(testing::coarse_profile());
  Observation o = make_observation(CellState::kContact, 6.0, 0.0, std::numbers::pi, 0);
  const ForceEstimate a = sharp.process(o);
  o.indentation_sigma_um = 3.0;
  const ForceEstimate b = blurred.process(o);
  EXPECT_GT(b.by_picture.upper_uN - b.by_picture.lower_uN, 1.4 * (a.by_picture.upper_uN - a.by_picture.lower_uN));
  EXPECT_GT(b.contact_force_upper_uN, a.contact_force_upper_uN);
  EXPECT_EQ(b.by_scale.upper_uN, a.by_scale.upper_uN);
}

// A contact counts once it is confirmed: until then a needle at the membrane may press, as far as its tip's place
// leaves open. One that is seen far inside an untouched cell is above it.
TEST(ForceObserver, ANeedleAtAnUntouchedMembraneLeavesAForceOpen) {
  double last_uN = 0.0;
  for (const double tip_um : {-2.0, 0.0, 1.0, 2.0, 12.0}) {
    ForceObserver observer(testing::coarse_profile());
    Observation o = make_observation(CellState::kFree, 0.0, 0.3, 0.3 + std::numbers::pi, 0);
    o.needle->tip_um += tip_um * o.needle->direction;
    o.needle->tip_sigma_um = 0.2;
    const ForceEstimate estimate = observer.process(o);
    EXPECT_EQ(estimate.contact_force_uN, 0.0) << tip_um;
    EXPECT_EQ(estimate.contact_force_lower_uN, 0.0) << tip_um;
    if (tip_um < -1.0 || tip_um > 3.0) {
      EXPECT_EQ(estimate.contact_force_upper_uN, 0.0) << tip_um;
      continue;
    }
    EXPECT_GT(estimate.by_picture.upper_uN, last_uN) << tip_um;
    EXPECT_GT(estimate.contact_force_upper_uN, estimate.by_picture.upper_uN) << tip_um;
    last_uN = estimate.by_picture.upper_uN;
  }
  // About as much as a contact of that depth would leave open.
  ForceObserver observer(testing::coarse_profile());
  const ForceEstimate pressed =
      observer.process(make_observation(CellState::kContact, 2.4, 0.3, 0.3 + std::numbers::pi, 0));
  EXPECT_LT(last_uN, 2.0 * pressed.by_picture.upper_uN);
}

// Glass that comes from within the holder's mouth pushes nothing; beside the mouth it may.
TEST(ForceObserver, WhatComesFromTheHoldersMouthIsNoNeedle) {
  // At 0.5 rad the needle's line runs beside the mouth, but needle and pipette would overlap.
  for (const double away_rad : {0.0, 0.15, 0.5, 0.9, 1.6}) {
    ForceObserver observer(testing::coarse_profile());
    const ForceEstimate estimate = observer.process(make_observation(CellState::kContact, 6.0, 0.3, 0.3 + away_rad, 0));
    const bool within = away_rad < 0.6;
    EXPECT_EQ(std::isfinite(estimate.contact_force_uN), !within) << away_rad;
    EXPECT_EQ(estimate.reason.empty(), !within) << away_rad;
  }
}

TEST(ForceObserver, ACellFarLargerThanTheProfilesIsItsOwnSize) {
  // F goes with R^-1.9: a cell of 60 um is softer than one of 50 um.
  ForceObserver usual(testing::coarse_profile()), large(testing::coarse_profile());
  Observation o = make_observation(CellState::kContact, 15.0, 0.0, std::numbers::pi, 0);
  const double force = usual.process(o).contact_force_uN;
  o.rest_outer_radius_um = 62.5;
  o.rest_inner_radius_um = 57.5;  // 10 um more: the tip is that much further out
  o.needle->tip_um += 10.0 * o.axis;
  const double softer = large.process(o).contact_force_uN;
  EXPECT_LT(softer, 0.95 * force);
  EXPECT_GT(softer, 0.5 * force);
}

// The modulus scales forces and no shape: a solution serves every modulus. With the same modulus it is the same bits.
TEST(ForceObserver, AShapeSolvedUnderAnotherModulusGivesTheForcesOfThisOne) {
  const CellProfile profile = load_profile("mouse-oocyte");
  CellProfile stiffer = profile;
  stiffer.effective_young_modulus_kPa *= 1.7;
  ForceObserver solving(profile), same(profile), sharing(stiffer), alone(stiffer);
  for (int frame = 0; frame <= 30; ++frame) {
    const double depth_um = 0.7 * frame;
    const auto o = make_observation(frame > 0 ? CellState::kContact : CellState::kFree, depth_um, 0.3,
                                    0.3 + std::numbers::pi, frame);
    const ForceEstimate solved = solving.process(o);
    const auto shape = solving.solved_shape();
    ASSERT_EQ(shape != nullptr, frame > 0);
    const ForceEstimate equal = same.process(o, shape.get());
    EXPECT_EQ(equal.contact_force_uN, solved.contact_force_uN);
    EXPECT_EQ(equal.contact_force_upper_uN, solved.contact_force_upper_uN);
    EXPECT_EQ(equal.stiffness_uN_per_um, solved.stiffness_uN_per_um);
    EXPECT_EQ(equal.pressure_Pa, solved.pressure_Pa);
    EXPECT_EQ(equal.force_uN, solved.force_uN);
    const ForceEstimate shared = sharing.process(o, shape.get());
    const ForceEstimate own = alone.process(o);
    const double tolerance = 1e-5 * (1e-3 + own.contact_force_uN);
    EXPECT_NEAR(shared.contact_force_uN, 1.7 * solved.contact_force_uN, 1e-9 * (1.0 + own.contact_force_uN));
    EXPECT_NEAR(shared.contact_force_uN, own.contact_force_uN, tolerance);
    EXPECT_NEAR(shared.contact_force_lower_uN, own.contact_force_lower_uN, 10.0 * tolerance);
    EXPECT_NEAR(shared.stiffness_uN_per_um, own.stiffness_uN_per_um, 1e-4 * own.stiffness_uN_per_um + 1e-9);
    EXPECT_LT((shared.force_uN - own.force_uN).cwiseAbs().maxCoeff(), 1e-4);
  }
}

}  // namespace
}  // namespace pellucida
