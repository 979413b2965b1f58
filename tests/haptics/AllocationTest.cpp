// Ten thousand ticks with everything switched on, through contact, puncture and faults: not one allocation.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "haptics/HandRun.h"
#include "haptics/SimulatedArm.h"
#include "pellucida/haptics/DeviceCatalog.h"
#include "tracking/AllocationCounter.h"

namespace pellucida {
namespace {

TEST(HapticAllocation, TheCounterCounts) {
  const test::AllocationCounter counter;
  const std::vector<double> some(100, 1.0);
  EXPECT_EQ(counter.count(), 1U) << some.front();
}

TEST(HapticAllocation, TenThousandTicksAskForNoMemory) {
  const DeviceSpecification device = find_device("Touch");
  constexpr double kScale_um_per_m = 2000.0;
  HapticSettings settings = default_settings(device, kScale_um_per_m);
  FixtureSet& fixtures = settings.fixtures;
  fixtures.guide.enabled = fixtures.cone.enabled = fixtures.stop.enabled = true;
  fixtures.cell.enabled = fixtures.holder.enabled = true;
  fixtures.cell.center_um = PlainVector3(60.0, 0.0, 0.0);
  fixtures.holder.mouth_um = PlainVector3(100.0, 0.0, 0.0);

  test::SimulatedArm arm(device, {});
  test::DirectMap map(kScale_um_per_m);
  LatestValue<ContactModel> contact;
  LatestValue<PipetteState> pipette;
  LatestValue<PipetteCommand> command;
  HapticServo servo(arm, map, HapticPorts{contact, pipette, command}, settings);
  const test::CubicCell cell{.contact_x_um = 20.0};

  std::size_t fixtures_acted = 0, contact_felt = 0;
  const test::AllocationCounter counter;
  for (int k = 0; k < 10000; ++k) {
    const double now_s = 1e-3 * k;
    arm.intent_m = Eigen::Vector3d(0.04 * std::sin(2.0 * now_s), 0.02 * std::sin(3.0 * now_s), 0.0);
    arm.lost = k > 7000 && k < 7100;
    arm.says_nan = k > 7500 && k < 7510;
    arm.buttons = 0;
    if (k > 8000 && k < 8100) arm.buttons = kClutch;
    if (k > 8500 && k < 8600) arm.buttons = kRetract;
    arm.advance(1e-3);
    command.refresh();
    PipetteState state;
    state.known = true;
    state.time_s = now_s;
    state.tip_um = command.value().tip_um;
    pipette.publish(state);
    if (k % 33 == 0) {
      ContactModel model;
      model.time_s = now_s;
      model.frame_index = k / 33;
      const double depth = cell.depth_um(state.tip_um.x);
      model.state = k > 9000 && k < 9100 ? CellState::kPunctured : depth > 0.0 ? CellState::kContact : CellState::kFree;
      model.valid = true;
      model.push = PlainVector3(1.0, 0.0, 0.0);
      model.force_uN = PlainVector3(-cell.force_at(depth), 0.0, 0.0);
      model.stiffness_uN_per_um = cell.stiffness_at(depth);
      model.depth_um = depth;
      contact.publish(model);
    }
    if (k == 5000) servo.emergency_stop();
    if (k == 5500) servo.release_emergency_stop();
    servo.turn(now_s);
    while (const auto record = servo.records().pop()) {
      fixtures_acted += record->fixtures != 0;
      contact_felt += record->contact_force_uN.x < 0.0;
    }
    while (servo.events().pop()) {
    }
  }
  const std::size_t count = counter.count();
  EXPECT_EQ(count, 0U);
  EXPECT_GT(fixtures_acted, 1000U) << "the ticks did something";
  EXPECT_GT(contact_felt, 1000U);
  EXPECT_EQ(servo.tick_count(), 10000U);
}

}  // namespace
}  // namespace pellucida
