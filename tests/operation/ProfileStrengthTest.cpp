#include "pellucida/operation/ProfileStrength.h"

#include <gtest/gtest.h>

#include <fstream>

#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/haptics/DeviceCatalog.h"
#include "pellucida/haptics/HapticSettings.h"
#include "pellucida/operation/SimulatedInjectionSource.h"
#include "pellucida/pipeline/BatchRun.h"

namespace pellucida {
namespace {

class ShippedProfile : public testing::TestWithParam<const char*> {
 protected:
  CellProfile profile_ = load_profile(GetParam());
  CellStrength strength_ = strength_of(profile_);
};
INSTANTIATE_TEST_SUITE_P(All, ShippedProfile, testing::Values("mouse-oocyte", "mouse-embryo", "oocyte-afm"));

// A cell as strong as its kind can be punctured, and nothing much stronger is pushed.
TEST_P(ShippedProfile, TheLimitsLieJustAboveThePuncture) {
  const HapticSettings settings = default_settings(find_device("Touch"), 2000.0, strength_);
  EXPECT_GE(settings.limits.slow_ratio * settings.limits.max_force_uN, profile_.puncture_force_uN);
  EXPECT_LE(settings.limits.max_force_uN, 1.3 * profile_.puncture_force_uN);
  EXPECT_GE(settings.limits.max_depth_um - settings.limits.soft_depth_um, profile_.puncture_indentation_um);
  EXPECT_LE(settings.limits.max_depth_um, 1.3 * profile_.puncture_indentation_um);
  EXPECT_FALSE(fault_of(settings, find_device("Touch"), 2000.0));
}

// A wanted place far ahead, a cell whose force grows with the third power of depth and that never gives way: the tip
// stops at the limit's force, not beyond.
TEST_P(ShippedProfile, ThePushIsHeldAtTheForceLimit) {
  HapticSettings settings = default_settings(find_device("Touch"), 2000.0, strength_);
  settings.limits.max_depth_um = 1e3;
  CellGuards guards(settings.limits);
  guards.place(Eigen::Vector3d::Zero());
  double deepest_um = 0.0;
  for (int tick = 0; tick < 20000; ++tick) {
    const double depth_um = guards.tip_um().x();
    GuardInput input;
    input.wanted_um = {200.0, 0.0, 0.0};
    input.push = Eigen::Vector3d::UnitX();
    input.in_contact = true;
    input.depth_um = depth_um;
    input.contact_force_uN = profile_.puncture_force_uN * std::pow(depth_um / profile_.puncture_indentation_um, 3);
    input.pipette.tip_um = Eigen::Vector3d(guards.tip_um());
    guards.follow(input);
    deepest_um = std::max(deepest_um, guards.tip_um().x());
  }
  const double force_uN = profile_.puncture_force_uN * std::pow(deepest_um / profile_.puncture_indentation_um, 3);
  EXPECT_GT(force_uN, 1.2 * profile_.puncture_force_uN);
  EXPECT_LT(force_uN, 1.01 * settings.limits.max_force_uN);
}

// The limits are those of the cell in view, within reason.
TEST_P(ShippedProfile, TheCellInViewSetsTheLimits) {
  Measurement seen;
  EXPECT_EQ(strength_of(profile_, seen).puncture_force_uN, profile_.puncture_force_uN);
  seen.expected_puncture_uN = 0.4 * profile_.puncture_force_uN;
  seen.expected_puncture_um = 0.7 * profile_.puncture_indentation_um;
  const CellStrength fine = strength_of(profile_, seen);
  EXPECT_EQ(fine.puncture_force_uN, seen.expected_puncture_uN);
  EXPECT_EQ(fine.puncture_depth_um, seen.expected_puncture_um);
  EXPECT_LT(fine.max_stiffness_uN_per_um, strength_.max_stiffness_uN_per_um);
  seen.expected_puncture_uN = 7.0 * profile_.puncture_force_uN;
  EXPECT_EQ(strength_of(profile_, seen).puncture_force_uN, 2.0 * profile_.puncture_force_uN);
}

struct Injected {
  InjectionOutcome outcome;
  double peak_uN = 0.0;  // of the hand's contact force
  bool force_limit_acted = false;
};

Injected inject(const std::string& profile, const std::string& scenario_text) {
  const TemporaryFolder folder;
  std::ofstream(folder / "scenario.json") << scenario_text;
  SimulatedInjectionOptions options;
  options.scenario = (folder / "scenario.json").string();
  options.cell = strength_of(load_profile(profile));
  options.max_duration_s = 40.0;
  SimulatedInjectionSource microscope(options);
  BatchOptions batch;
  batch.pipeline.profile = profile;
  Injected injected;
  run_batch(microscope, batch, [&](const Scene& scene) {
    microscope.see(scene);
    for (const HapticRecord& tick : microscope.take_records()) {
      injected.peak_uN = std::max(injected.peak_uN, tick.contact_force_uN.eigen().norm());
      injected.force_limit_acted = injected.force_limit_acted || (tick.limits & limit_bit(LimitKind::kForce)) != 0;
    }
  });
  injected.outcome = microscope.outcome();
  return injected;
}

TEST(ProfileStrength, AnOocyteOfItsKindIsInjected) {
  const Injected oocyte = inject("mouse-oocyte", R"({"puncture": {"enabled": true, "indentation_um": 44}})");
  EXPECT_TRUE(oocyte.outcome.done) << oocyte.outcome.duration_s << " s";
  EXPECT_GT(oocyte.outcome.puncture_force_uN, 7.0);
  EXPECT_GT(oocyte.outcome.deposited_pL, 1.0);
}

TEST(ProfileStrength, AnEmbryoOfItsKindIsInjected) {
  const Injected embryo =
      inject("mouse-embryo",
             R"({"cell": {"reference": "mouse-embryo"}, "puncture": {"enabled": true, "indentation_um": 52}})");
  EXPECT_TRUE(embryo.outcome.done) << embryo.outcome.puncture_depth_um << " um deep, " << embryo.peak_uN << " uN, "
                                   << (embryo.force_limit_acted ? "at the limit" : "below the limit");
  EXPECT_GT(embryo.outcome.puncture_force_uN, 11.0);
  EXPECT_GT(embryo.outcome.deposited_pL, 1.0);
}

// An embryo taken for an oocyte measures less than it bears, but still more than any oocyte: the limit holds the push
// before the membrane gives way at 12 uN.
TEST(ProfileStrength, AnEmbryoUnderTheOocytesProfileIsHeldBeforeItsPuncture) {
  const Injected held =
      inject("mouse-oocyte",
             R"({"cell": {"reference": "mouse-embryo"}, "puncture": {"enabled": true, "indentation_um": 52}})");
  EXPECT_LT(held.outcome.puncture_s, 0.0) << "punctured at " << held.outcome.puncture_force_uN << " uN";
  EXPECT_TRUE(held.force_limit_acted);
  EXPECT_LT(held.peak_uN, 1.1 * kPunctureMargin * 7.5);
}

}  // namespace
}  // namespace pellucida
