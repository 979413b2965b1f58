// What the observer makes of a contour besides its depth, of needles beside the centre, punctures, palpations.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "SectionContours.h"
#include "pellucida/core/Error.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/membrane/Indenter.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

constexpr double kOuterRadius_um = 52.5;

/// A cell at (200, 150) um, the needle along `axis_rad` (from the needle's side), its line `offset_um` beside the
/// centre, `depth_um` past the resting outline.
Observation push(double depth_um, double axis_rad, double holder_rad, double offset_um, long frame) {
  Observation o;
  o.time_s = static_cast<double>(frame) / 30.0;
  o.frame_index = frame;
  o.state = depth_um > 0.0 ? CellState::kContact : CellState::kFree;
  o.confidence = 1.0;
  o.center_um = {200.0, 150.0};
  o.rest_outer_radius_um = kOuterRadius_um;
  o.rest_inner_radius_um = 47.5;
  o.outer.emplace();
  o.axis = {std::cos(axis_rad), std::sin(axis_rad)};
  const Eigen::Vector2d along = -o.axis, left(-along.y(), along.x());
  const Eigen::Vector2d entry =
      o.center_um - offset_um * left - std::sqrt(kOuterRadius_um * kOuterRadius_um - offset_um * offset_um) * along;
  o.needle = NeedlePose{entry + depth_um * along, along, 5.0, 1.0, 0.2};
  HolderPose holder;
  holder.direction = {std::cos(holder_rad), std::sin(holder_rad)};
  o.holder = holder;
  o.indentation_um = depth_um;
  o.indentation_sigma_um = 0.15;
  return o;
}

TEST(ForceObserver, ANeedleBesideTheCentrePushesAskew) {
  const CellProfile profile = load_profile("mouse-oocyte");
  const auto curve = force_curve(profile, 4, 20.0, 1.0);
  for (const double offset : {10.0, -10.0}) {
    ForceObserver observer(profile);
    ForceEstimate e;
    for (int frame = 0; frame <= 40; ++frame) {
      e = observer.process(push(0.5 * frame, 0.4, 0.4 + std::numbers::pi, offset, frame));
    }
    EXPECT_NEAR(e.contact_force_uN, curve.back().push_force_uN, 1e-6 * curve.back().push_force_uN) << offset;
    const double lateral =
        std::sqrt(curve.back().tip_force_uN.squaredNorm() - curve.back().push_force_uN * curve.back().push_force_uN);
    EXPECT_NEAR(e.lateral_force_uN, lateral, 1e-6 * e.contact_force_uN) << offset;
    EXPECT_NEAR(e.tip_force_uN.norm(), std::hypot(e.contact_force_uN, e.lateral_force_uN), 1e-9);
    // The contact point lies where the needle's line enters the cell.
    EXPECT_NEAR(std::acos(e.rotation_WC.col(2).head<2>().dot(Eigen::Vector2d(std::cos(0.4), std::sin(0.4)))),
                std::asin(10.0 / kOuterRadius_um), 1e-6);
    EXPECT_EQ(e.warnings, kNoForceWarning);
  }
}

TEST(ForceObserver, ANeedleThatLeavesItsLineHasSlipped) {
  ForceObserver observer(testing::coarse_profile());
  ForceEstimate e;
  for (int frame = 0; frame <= 40; ++frame) {
    e = observer.process(push(0.5 * frame, 0.0, std::numbers::pi, frame > 20 ? 8.0 : 0.0, frame));
    if (frame <= 20) {
      EXPECT_FALSE(e.warnings & kNeedleSlip) << frame;
    }
  }
  EXPECT_TRUE(e.warnings & kNeedleSlip);
}

TEST(ForceObserver, ForceIsZeroInTheFrameThatShowsThePuncture) {
  ForceObserver observer(testing::coarse_profile());
  ForceEstimate e;
  double before_uN = 0.0;
  for (int frame = 0; frame <= 60; ++frame) {
    e = observer.process(push(0.5 * frame, 0.0, std::numbers::pi, 0.0, frame));
    EXPECT_FALSE(e.punctured);
    before_uN = e.contact_force_uN;
  }
  // The tracker still says contact; the membrane has come back to 20 um, the tip has gone on.
  Observation o = push(30.5, 0.0, std::numbers::pi, 0.0, 61);
  o.indentation_um = 20.0;
  e = observer.process(o);
  EXPECT_TRUE(e.punctured);
  EXPECT_EQ(e.contact_force_uN, 0.0);
  EXPECT_EQ(e.contact_force_upper_uN, 0.0);
  ASSERT_TRUE(e.puncture);
  EXPECT_NEAR(e.puncture->peak_force_uN, before_uN, 1e-9);
  EXPECT_NEAR(e.puncture->depth_um, 30.0, 1e-6);
  EXPECT_GT(e.puncture->work_uN_um, 0.2 * before_uN * 30.0);
  EXPECT_LT(e.puncture->work_uN_um, 0.6 * before_uN * 30.0);
  // Then the tracker says so too: no second event.
  o = push(31.0, 0.0, std::numbers::pi, 0.0, 62);
  o.state = CellState::kPunctured;
  o.indentation_um = 8.0;
  EXPECT_FALSE(observer.process(o).puncture);
}

TEST(ForceObserver, AWrongConfigurationIsFlaggedAndWidensTheInterval) {
  const CellProfile profile = load_profile("mouse-oocyte");
  Indenter across(profile, setup_for_configuration(profile, 3));
  ForceObserver right(profile), wrong(profile);
  ForceEstimate a, b;
  for (int frame = 0; frame <= 60; ++frame) {
    const double depth = 0.5 * frame;
    across.advance_to(depth);
    // Frame C of `setup_for_configuration`: z to the needle, the holder towards +x, i.e. (-z.y, z.x) in the image.
    Observation o = push(depth, 0.0, 0.5 * std::numbers::pi, 0.0, frame);
    testing::add_contours(o, across.model().rest(), across.positions_um(), o.axis, 5.0);
    a = right.process(o);
    EXPECT_EQ(a.warnings, kNoForceWarning) << depth;
    // The holder taken for one opposite the needle.
    o.holder->direction = {-1.0, 0.0};
    b = wrong.process(o);
  }
  // Found: 6.7e-5, what reading off the path differs from solving by.
  EXPECT_LT(a.shape.residual_rms_um, 1.5e-4);
  EXPECT_EQ(a.errors.shape_uN, 0.0);
  EXPECT_TRUE(b.warnings & kShapeMismatch) << b.shape.residual_rms_um;
  EXPECT_TRUE(b.warnings & kNotOfRevolution);
  EXPECT_GT(b.errors.shape_uN, 0.0);
  EXPECT_GT(b.asymmetry_force_uN, 0.0);
  // No fit is forced: the interval says that the force isn't known.
  const auto width = [](const ForceEstimate& e) {
    return (e.by_picture.upper_uN - e.by_picture.lower_uN) / e.contact_force_uN;
  };
  EXPECT_GT(width(b), 1.3 * width(a));
  EXPECT_EQ(to_string(b.warnings), "mismatch+asymmetry");
}

TEST(ForceObserver, APalpationMakesTheForcesThisCellsOwn) {
  const CellProfile profile = testing::coarse_profile();
  ForceObserver usual(profile), palpated(profile);
  const double model_uN = usual.process(push(5.0, 0.0, std::numbers::pi, 0.0, 0)).contact_force_uN;
  palpated.set_scale_measurements({{.known_force_uN = 1.5 * model_uN,
                                    .at_indentation_um = 5.0,
                                    .at_indentation_sigma_um = 0.1,
                                    .known_force_sigma_percent = 3.0}});
  const ForceEstimate before = usual.process(push(20.0, 0.0, std::numbers::pi, 0.0, 40));
  const ForceEstimate after = palpated.process(push(20.0, 0.0, std::numbers::pi, 0.0, 40));
  EXPECT_NEAR(palpated.scale().ratio, 1.5, 0.026);
  EXPECT_LT(palpated.scale().relative_sigma, 0.15);
  EXPECT_GT(palpated.scale().relative_sigma, 0.03);
  EXPECT_NEAR(after.contact_force_uN, palpated.scale().ratio * before.contact_force_uN, 1e-6 * after.contact_force_uN);
  // The picture leaves open what it did; how cells of the kind differ no longer counts.
  EXPECT_NEAR(before.errors.scale_ratio, std::hypot(profile.kind_spread_ratio, profile.force_scale_relative_sigma),
              1e-12);
  EXPECT_EQ(after.errors.scale_ratio, palpated.scale().relative_sigma);
  EXPECT_NEAR(after.errors.model_ratio, before.errors.model_ratio, 1e-6);
  // The push knew the sizes' error too: most of it is gone.
  EXPECT_LT(after.errors.geometry_ratio, 0.5 * before.errors.geometry_ratio);
  EXPECT_LT(after.by_scale.upper_uN / after.contact_force_uN, 0.6 * before.by_scale.upper_uN / before.contact_force_uN);
  EXPECT_TRUE(std::isnan(before.puncture_probability));
  EXPECT_GT(after.puncture_probability, 0.0);
  EXPECT_LT(after.puncture_probability, 0.5);

  // A stiffer cell is punctured less deep, and its risk is asked for less deep.
  const auto risk = palpated.puncture_risk(5.0), usual_risk = usual.puncture_risk(5.0);
  ASSERT_GE(risk.size(), 8u);
  ASSERT_GT(usual_risk.size(), risk.size());
  for (std::size_t k = 0; k < risk.size(); ++k) {
    EXPECT_GE(risk[k].probability, k > 0 ? risk[k - 1].probability : 0.0);
    EXPECT_GT(risk[k].force_uN, usual_risk[k].force_uN);
  }
  EXPECT_GT(risk[7].probability, usual_risk[7].probability);

  // The same by a stiffness; and nonsense is refused.
  const double stiffness = usual.process(push(5.0, 0.0, std::numbers::pi, 0.0, 80)).stiffness_uN_per_um;
  ForceObserver by_stiffness(profile);
  by_stiffness.set_scale_measurements({{.known_stiffness_uN_per_um = 0.7 * stiffness,
                                        .at_indentation_um = 5.0,
                                        .at_indentation_sigma_um = 0.05,
                                        .known_force_sigma_percent = 3.0}});
  by_stiffness.process(push(1.0, 0.0, std::numbers::pi, 0.0, 0));
  EXPECT_NEAR(by_stiffness.scale().ratio, 0.7, 0.01);
  EXPECT_THROW(by_stiffness.set_scale_measurements({{}}), UsageError);
  // An aspiration without its modulus says nothing.
  EXPECT_THROW(by_stiffness.set_scale_measurements({{.suction_kPa = 1.0, .tongue_um = 8.0, .mouth_radius_um = 10.0}}),
               UsageError);
  EXPECT_THROW(by_stiffness.set_scale({0.0, 0.1}), UsageError);
}

TEST(ForceObserver, AScaleCountsFromItsTimeOnAndCanBeForgotten) {
  ForceObserver observer(testing::coarse_profile());
  EXPECT_FALSE(observer.has_own_scale());
  const double kind_uN = observer.process(push(10.0, 0.0, std::numbers::pi, 0.0, 0)).contact_force_uN;
  ScaleMeasurement modulus{.suction_kPa = 2.0, .tongue_um = 8.0, .mouth_radius_um = 10.0};
  modulus.modulus_kPa = 1.4 * 1.25 * observer.profile().effective_young_modulus_kPa;
  modulus.modulus_of_profile_ratio = 1.25;
  modulus.modulus_sigma_percent = 4.0;
  modulus.since_s = 1.0;
  observer.set_scale_measurements({modulus});
  const ForceEstimate before = observer.process(push(10.0, 0.0, std::numbers::pi, 0.0, 15));
  EXPECT_FALSE(observer.has_own_scale());
  EXPECT_DOUBLE_EQ(before.contact_force_uN, kind_uN);
  const ForceEstimate after = observer.process(push(10.0, 0.0, std::numbers::pi, 0.0, 30));
  EXPECT_TRUE(observer.has_own_scale());
  EXPECT_NEAR(observer.scale().ratio, 1.4, 0.01);
  EXPECT_NEAR(observer.scale().relative_sigma, 0.04, 0.001);
  EXPECT_NEAR(after.contact_force_uN / kind_uN, observer.scale().ratio, 1e-6);
  // A modulus says nothing of the sizes.
  EXPECT_DOUBLE_EQ(after.errors.geometry_ratio, before.errors.geometry_ratio);
  observer.set_scale_measurements({});
  EXPECT_NEAR(observer.process(push(10.0, 0.0, std::numbers::pi, 0.0, 31)).contact_force_uN, kind_uN, 1e-6 * kind_uN);
  EXPECT_FALSE(observer.has_own_scale());
}

// What a push of known force leaves of the sizes' error: a model of wrong sizes, scaled to the truth at 5 um.
TEST(ForceObserver, APushTakesMostOfTheSizesErrorWithIt) {
  const CellProfile profile = testing::coarse_profile();
  const auto curve = [&](double thickness, double tip, double holder) {
    MembraneGeometry geometry = geometry_of(profile);
    geometry.thickness_um *= thickness;
    geometry.tip_radius_um *= tip;
    geometry.holder_radius_um *= holder;
    Indenter indenter(profile, geometry, {0.0, 0.0, -1.0}, {0.0, 0.0, -1.0});
    std::vector<double> forces;
    for (const double depth : {5.0, 10.0, 20.0, 30.0, 44.0}) forces.push_back(indenter.advance_to(depth).push_force_uN);
    return forces;
  };
  const auto right = curve(1.0, 1.0, 1.0);
  double squares_before = 0.0, squares_after = 0.0;
  for (const auto& wrong : {curve(1.08, 1.0, 1.0), curve(1.0, 1.15, 1.0), curve(1.0, 1.0, 1.08)}) {
    const double at_push = std::log(wrong[0] / right[0]);
    for (std::size_t k = 1; k < right.size(); ++k) {
      const double off = std::log(wrong[k] / right[k]);
      std::printf("depth %zu: off by %.3f, after the push by %.3f\n", k, off, off - at_push);
      squares_before += off * off;
      squares_after += (off - at_push) * (off - at_push);
    }
  }
  std::printf("left: %.2f\n", std::sqrt(squares_after / squares_before));
  EXPECT_LT(std::sqrt(squares_after / squares_before), 0.45);
}

TEST(ForceObserver, StampsItsFrameAndTellsTheHandWhatItFeels) {
  ForceObserver observer(testing::coarse_profile());
  observer.process(push(3.0, 0.0, std::numbers::pi, 0.0, 1));
  const ForceEstimate e = observer.process(push(3.5, 0.0, std::numbers::pi, 0.0, 2));
  EXPECT_EQ(e.frame_index, 2);
  EXPECT_DOUBLE_EQ(e.time_s, 2.0 / 30.0);
  EXPECT_GT(e.stiffness_uN_per_um, 0.05);
  EXPECT_GT(e.damping_uN_s_per_um, 0.0);
  // No more than all dampers of the patch could give.
  EXPECT_LT(e.damping_uN_s_per_um, 1.0);
  EXPECT_GT(e.work_uN_um, 0.0);
}

TEST(ForceObserver, AWeakPullOfThatVeryContourChangesNothing) {
  const CellProfile profile = load_profile("mouse-oocyte");
  Indenter truth(profile, setup_for_configuration(profile, 1));
  ForceObserver alone(profile), pulled(profile, {.observation_ratio = 1e-5});
  ForceEstimate a, b;
  for (int frame = 0; frame <= 20; ++frame) {
    truth.advance_to(0.7 * frame);
    Observation o = push(0.7 * frame, 0.0, std::numbers::pi, 0.0, frame);
    testing::add_contours(o, truth.model().rest(), truth.positions_um(), o.axis, 5.0);
    a = alone.process(o);
    b = pulled.process(o);
  }
  EXPECT_NEAR(b.contact_force_uN, a.contact_force_uN, 2e-5 * a.contact_force_uN);
  EXPECT_TRUE(b.converged);
  EXPECT_THROW(ForceObserver(profile, {.observation_ratio = -1.0}), UsageError);
}

}  // namespace
}  // namespace pellucida
