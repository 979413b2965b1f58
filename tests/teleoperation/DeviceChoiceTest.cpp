#include "pellucida/teleoperation/DeviceChoice.h"

#include <gtest/gtest.h>

#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/DeviceSearch.h"

namespace pellucida {
namespace {

TEST(DeviceChoice, AMouseIsAlwaysThereAndComesWithPositionControl) {
  const ChosenHand hand = open_hand_device("mouse");
  ASSERT_TRUE(hand.device);
  EXPECT_TRUE(hand.mouse);
  EXPECT_TRUE(hand.cue);
  EXPECT_EQ(hand.settings.control, TeleoperationSettings::Control::kPosition);
  EXPECT_FALSE(hand.tremor.enabled);
}

TEST(DeviceChoice, AnUnknownNameIsRefusedWithThoseKnown) {
  try {
    open_hand_device("glove");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("spacemouse"), std::string::npos) << error.what();
  }
  EXPECT_THROW(make_manipulator("eppendorf"), UsageError);
  EXPECT_THROW(make_manipulator("simulated:x"), UsageError);
  EXPECT_THROW(open_hand_device("gamepad:no pad has such a name"), DeviceError);
}

TEST(DeviceChoice, ManipulatorsAreMadeClosed) {
  SimulatedInjectorOptions options;
  options.start_um = {1.0, 2.0, 3.0};
  InjectorPose seen;
  const auto simulated = make_manipulator("simulated", options, [&seen](const InjectorPose& pose) { seen = pose; });
  EXPECT_FALSE(simulated->is_open());
  simulated->open();
  EXPECT_NEAR(simulated->state(0.0).tip_um.y, 2.0, 1e-9);
  simulated->state(0.1);
  EXPECT_EQ(seen.tip_um.z, 3.0);
  const auto eppendorf = make_manipulator("eppendorf:/dev/ttyPELLUCIDA");
  EXPECT_FALSE(eppendorf->is_open());
  EXPECT_THROW(eppendorf->open(), DeviceError);
}

TEST(DeviceSearch, EveryUsableNameCanBeChosen) {
  for (const auto& report : search_manipulators()) {
    if (report.kind != "manipulator" || !report.usable) continue;
    EXPECT_TRUE(make_manipulator(report.name)) << report.name;
  }
  for (const auto& report : search_hand_devices()) {
    EXPECT_FALSE(report.detail.empty()) << report.name;
    try {
      open_hand_device(report.name);
      EXPECT_TRUE(report.usable) << report.name;
    } catch (const DeviceError& error) {
      // What is said to be usable may still be without its hardware, but has to say so.
      EXPECT_FALSE(std::string(error.what()).empty());
    }
  }
}

TEST(TeleoperationSettings, ScalePositionAndRateAlike) {
  const TeleoperationSettings coarse = at_scale({}, kCoarseScale_um_per_m);
  EXPECT_EQ(coarse.scale_um_per_m, 10000.0);
  EXPECT_EQ(coarse.rate_um_per_s_per_m, 20000.0);
  EXPECT_EQ(at_scale({}, kFineScale_um_per_m).rate_um_per_s_per_m, TeleoperationSettings{}.rate_um_per_s_per_m);
}

}  // namespace
}  // namespace pellucida
