#include <gtest/gtest.h>

#include "pellucida/core/FieldTable.h"
#include "pellucida/haptics/DeviceCatalog.h"
#include "pellucida/haptics/HapticSettings.h"
#include "pellucida/haptics/PassivityObserver.h"
#include "pellucida/haptics/ScalingCheck.h"
#include "pellucida/haptics/VirtualCoupling.h"
#include "support/DocsPage.h"

namespace pellucida {
namespace {

using Vector = Eigen::Vector3d;

// Motion 1/500 and 2 N at puncture: 273 N/m at the hand for the oocyte's 0.51 uN/um.
ScalingRequest oocyte_request() {
  ScalingRequest request;
  request.motion_scale_um_per_m = 2000.0;
  request.force_scale_N_per_uN = 2.0 / 7.5;
  return request;
}

TEST(ScalingCheck, TheHandsStiffnessIsTheCellsTimesBothScales) {
  const auto figures = check_scaling(find_device("Touch"), oocyte_request());
  ASSERT_TRUE(figures) << to_string(figures.error());
  EXPECT_NEAR(figures->stiffness_N_per_m, 272.0, 1e-9);
  EXPECT_NEAR(figures->force_N, 2.0, 1e-12);
}

TEST(ScalingCheck, WhatTheTouchCanNotHoldTheOmniDoes) {
  ScalingRequest request = oocyte_request();
  request.motion_scale_um_per_m = 5000.0;
  const auto touch = check_scaling(find_device("Touch"), request);
  ASSERT_FALSE(touch);
  EXPECT_EQ(touch.error().fault, ScalingFault::kStiffness);
  EXPECT_NEAR(touch.error().value, 680.0, 1e-9);
  EXPECT_TRUE(check_scaling(find_device("PHANTOM Omni"), request));
  // The nearest scale it names is accepted, a little more is not.
  request.force_scale_N_per_uN = touch.error().nearest_force_scale_N_per_uN;
  EXPECT_TRUE(check_scaling(find_device("Touch"), request));
  request.force_scale_N_per_uN *= 1.001;
  EXPECT_FALSE(check_scaling(find_device("Touch"), request));
}

TEST(ScalingCheck, ForceDampingAndPassivityAreBoundsToo) {
  DeviceSpecification device = find_device("Touch");
  ScalingRequest request = oocyte_request();
  request.force_scale_N_per_uN = 0.5;
  request.motion_scale_um_per_m = 500.0;
  ASSERT_FALSE(check_scaling(device, request));
  EXPECT_EQ(check_scaling(device, request).error().fault, ScalingFault::kForce);

  request = oocyte_request();
  request.cell.max_damping_uN_s_per_um = 0.01;
  ASSERT_FALSE(check_scaling(device, request));
  EXPECT_EQ(check_scaling(device, request).error().fault, ScalingFault::kDamping);

  // b > K T / 2: 272 N/m at 1 kHz need 0.136 N s/m.
  request = oocyte_request();
  device.physical_damping_N_s_per_m = 0.14;
  EXPECT_TRUE(check_scaling(device, request));
  device.physical_damping_N_s_per_m = 0.13;
  ASSERT_FALSE(check_scaling(device, request));
  EXPECT_EQ(check_scaling(device, request).error().fault, ScalingFault::kPassivity);
  request.force_scale_N_per_uN = check_scaling(device, request).error().nearest_force_scale_N_per_uN;
  EXPECT_TRUE(check_scaling(device, request));
  // A delay counts like half a period.
  request.delay_s = 0.5e-3;
  EXPECT_FALSE(check_scaling(device, request));
}

TEST(ScalingCheck, WithoutForceOrWithNonsenseItSaysSo) {
  EXPECT_EQ(check_scaling(find_device("Mouse"), oocyte_request()).error().fault, ScalingFault::kNoForce);
  ScalingRequest request = oocyte_request();
  request.force_scale_N_per_uN = -1.0;
  EXPECT_EQ(check_scaling(find_device("Touch"), request).error().fault, ScalingFault::kOutOfRange);
  request = oocyte_request();
  request.motion_scale_um_per_m = 0.0;
  EXPECT_EQ(check_scaling(find_device("Touch"), request).error().fault, ScalingFault::kOutOfRange);
}

TEST(HapticSettings, DefaultsHaveNoFaultOnAnyDeviceAtAnyUsualScale) {
  for (const DeviceSpecification& device : shipped_devices()) {
    for (const double scale : {500.0, 2000.0, 10000.0}) {
      const auto fault = fault_of(default_settings(device, scale), device, scale);
      EXPECT_FALSE(fault) << device.name << " at " << scale << ": " << *fault;
    }
  }
}

TEST(HapticSettings, DefaultsAreOnThePage) {
  HapticSettings settings;
  EXPECT_TRUE(docs_section_is("developer/hand-settings.md", "## Settings", markdown(fields_of(settings))));
}

TEST(HapticSettings, FaultsAreNamed) {
  const DeviceSpecification device = find_device("Touch");
  const auto fault_after = [&](auto change) {
    HapticSettings settings = default_settings(device, 2000.0);
    change(settings);
    return fault_of(settings, device, 2000.0).value_or("");
  };
  EXPECT_NE(fault_after([](HapticSettings& s) { s.limits.slow_ratio = 2.0; }).find("slow_ratio"), std::string::npos);
  EXPECT_NE(fault_after([](HapticSettings& s) { s.limits.upper_um.z = -2e4; }).find("lower_um"), std::string::npos);
  EXPECT_NE(fault_after([](HapticSettings& s) {
              s.fixtures.guide.enabled = true;
              s.fixtures.guide.axis = Vector(1.0, 1.0, 0.0);
            }).find("fixtures.guide: length of axis"),
            std::string::npos);
  EXPECT_NE(fault_after([](HapticSettings& s) { s.force_scale_N_per_uN = 1.0; }).find("take a force scale of"),
            std::string::npos);
  EXPECT_EQ(fault_after([](HapticSettings& s) { s.coupling.stiffness_N_per_m = 1e4; }),
            "coupling.stiffness_N_per_m is 10000; allowed: 0 to 400");
  EXPECT_EQ(fault_after([](HapticSettings& s) { s.limits.blind_age_s = 0.05; }),
            "limits.blind_age_s is 0.05; allowed: 0.1 or more");
  EXPECT_EQ(fault_after([](HapticSettings& s) { s.limits.late_tick_s = -1.0; }),
            "limits.late_tick_s is -1; allowed: 0 to 10");
  EXPECT_NE(fault_after([](HapticSettings& s) { s.low_pass_Hz = std::nan(""); }).find("low_pass_Hz"),
            std::string::npos);
}

TEST(VirtualCoupling, PullsTheHandTowardsTheProxyAndIsSlackOnIt) {
  CouplingSettings settings;
  settings.stiffness_N_per_m = 300.0;
  settings.damping_N_s_per_m = 0.0;
  const VirtualCoupling coupling(settings, find_device("Touch"));
  const Vector hand(10.0, 0.0, 0.0), still = Vector::Zero();
  EXPECT_EQ(coupling.force_N(hand, hand, still, 2000.0), Vector(0.0, 0.0, 0.0));
  // The proxy is 4 um behind: 2 mm at the hand, 0.6 N.
  EXPECT_NEAR(coupling.force_N(Vector(6.0, 0.0, 0.0), hand, still, 2000.0).x(), -0.6, 1e-12);
  EXPECT_NEAR(coupling.force_N(Vector(-1e6, 0.0, 0.0), hand, still, 2000.0).norm(), settings.max_force_N, 1e-12);
}

TEST(VirtualCoupling, NeverStifferThanTheDeviceHolds) {
  CouplingSettings settings;
  settings.stiffness_N_per_m = 1e5;
  settings.damping_N_s_per_m = 0.0;
  const VirtualCoupling coupling(settings, find_device("Touch"));
  EXPECT_NEAR(coupling.force_N(Vector::Zero(), Vector(1.0, 0.0, 0.0), Vector::Zero(), 2000.0).norm(), 400.0 / 2000.0,
              1e-12);
}

TEST(VirtualCoupling, AStifferCellScalesTheForceDownAndBack) {
  VirtualCoupling coupling({}, find_device("Touch"));
  const auto after = [&](double stiffness, double seconds) {
    double scale = 0.0;
    for (int k = 0; k < 1000 * seconds; ++k) scale = coupling.force_scale_N_per_uN(0.4, stiffness, 2000.0, 1e-3);
    return scale;
  };
  EXPECT_NEAR(after(0.4, 0.5), 0.4, 1e-12);
  EXPECT_FALSE(coupling.scaled_down());
  EXPECT_NEAR(after(1.0, 0.5), 0.2, 1e-12) << "800 N/m would be twice what a Touch holds";
  EXPECT_TRUE(coupling.scaled_down());
  EXPECT_NEAR(after(0.4, 1.5), 0.4, 1e-12);
}

TEST(PassivityObserver, ASpringGivesBackWhatItTook) {
  const DeviceSpecification device = find_device("Touch");
  PassivityObserver observer(device, 1e-3);
  Vector force = Vector::Zero();
  double lowest = 0.0, highest = 0.0;
  observer.rebase(Vector::Zero());
  for (int k = 1; k <= 2000; ++k) {
    const double x_m = 5e-3 * std::sin(2.0 * M_PI * k / 2000.0);
    observer.observe(Vector(x_m, 0.0, 0.0), force, 1e-3);
    force.x() = x_m > 0.0 ? -300.0 * x_m : 0.0;
    lowest = std::min(lowest, observer.margin_J());
    highest = std::max(highest, observer.margin_J());
  }
  EXPECT_NEAR(highest, 0.5 * 300.0 * 25e-6, 6e-6);
  EXPECT_GE(lowest, 0.0) << "the device's own friction covers the sampling";
  EXPECT_EQ(observer.damping_force_N(Vector(0.1, 0.0, 0.0), 1e-3).norm(), 0.0);
}

TEST(PassivityObserver, AMotorIsBraked) {
  const DeviceSpecification device = find_device("Touch");
  PassivityObserver observer(device, 1e-3);
  observer.rebase(Vector::Zero());
  // Pushes the hand the way it goes.
  for (int k = 1; k <= 100; ++k) observer.observe(Vector(1e-4 * k, 0.0, 0.0), Vector(1.0, 0.0, 0.0), 1e-3);
  EXPECT_LT(observer.margin_J(), -5e-3);
  Vector braking = observer.damping_force_N(Vector(0.1, 0.0, 0.0), 1e-3);
  EXPECT_LE(braking.norm(), 0.11 * 0.1 * device.max_damping_N_s_per_m) << "it sets in softly";
  for (int k = 0; k < 10; ++k) braking = observer.damping_force_N(Vector(0.1, 0.0, 0.0), 1e-3);
  EXPECT_NEAR(braking.x(), -0.1 * device.max_damping_N_s_per_m, 1e-12) << "as much as the device holds";
  // The braking is counted, and ends.
  double x_m = 1e-2;
  Vector force = braking;
  int ticks = 0;
  while (observer.margin_J() < 0.0 && ticks < 10000) {
    x_m += 1e-4;
    observer.observe(Vector(x_m, 0.0, 0.0), force, 1e-3);
    force = observer.damping_force_N(Vector(0.1, 0.0, 0.0), 1e-3);
    ++ticks;
  }
  EXPECT_LT(ticks, 1000);
}

TEST(PassivityObserver, WhatWasPutInLongAgoDoesNotPayForLater) {
  const DeviceSpecification device = find_device("Touch");
  PassivityObserver observer(device, 1e-3);
  observer.rebase(Vector::Zero());
  for (int k = 1; k <= 10000; ++k) observer.observe(Vector(1e-4 * k, 0.0, 0.0), Vector(-3.0, 0.0, 0.0), 1e-3);
  EXPECT_NEAR(observer.margin_J(), 5.0 * 3.3 * 3.3 / 400.0, 1e-9);
}

}  // namespace
}  // namespace pellucida
