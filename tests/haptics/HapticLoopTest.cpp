// The thread: start, stop, hand-over both ways beside writers. Run under the thread sanitizer too; nothing here asserts
// on wall-clock time.
#include "pellucida/haptics/HapticLoop.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "haptics/HandRun.h"
#include "haptics/SimulatedArm.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using namespace std::chrono_literals;

DeviceSpecification touch() {
  DeviceSpecification device;
  device.name = "Touch";
  device.max_force_N = 3.3;
  device.max_stiffness_N_per_m = 400.0;
  device.max_damping_N_s_per_m = 4.0;
  device.workspace_radius_m = 0.075;
  device.source = "test";
  return device;
}

// A device that counts, and that the loop's thread alone may use.
class CountingDevice final : public HapticDevice {
 public:
  explicit CountingDevice(DeviceSpecification specification) : specification_(std::move(specification)) {}
  const DeviceSpecification& specification() const noexcept override { return specification_; }
  bool read(double now_s, HandSample& sample) noexcept override {
    sample = HandSample{};
    sample.time_s = now_s;
    sample.position_m.x = 0.02;
    ++reads_;
    return true;
  }
  bool write(const PlainVector3& force_N) noexcept override {
    last_ = force_N;
    ++writes_;
    return true;
  }
  // After the loop has ended.
  long reads() const { return reads_; }
  long writes() const { return writes_; }
  PlainVector3 last() const { return last_; }

 private:
  DeviceSpecification specification_;
  long reads_ = 0, writes_ = 0;
  PlainVector3 last_;
};

struct Rig {
  CountingDevice device{touch()};
  test::DirectMap map{2000.0};
  LatestValue<ContactModel> contact;
  LatestValue<PipetteState> pipette;
  LatestValue<PipetteCommand> command;
  HapticSettings settings = default_settings(device.specification(), 2000.0);
  HapticServo servo{device, map, HapticPorts{contact, pipette, command}, settings};
  SteadyClock clock;
};

HapticLoopOptions quiet() {
  HapticLoopOptions options;
  options.lock_memory = false;
  return options;
}

void wait_for_ticks(const HapticServo& servo, std::uint64_t count) {
  while (servo.tick_count() < count) std::this_thread::sleep_for(1ms);
}

TEST(HapticLoop, TurnsUntilStoppedAndLeavesNoForce) {
  Rig rig;
  HapticLoop loop(rig.servo, rig.clock, quiet());
  EXPECT_FALSE(loop.running());
  loop.start();
  EXPECT_TRUE(loop.running());
  EXPECT_THROW(loop.start(), UsageError);
  wait_for_ticks(rig.servo, 50);
  loop.stop();
  loop.stop();
  EXPECT_FALSE(loop.running());
  const std::uint64_t ticks = rig.servo.tick_count();
  EXPECT_EQ(static_cast<long>(ticks), rig.device.reads());
  EXPECT_EQ(rig.device.writes(), rig.device.reads() + 1) << "one write a tick, and the zero at the end";
  EXPECT_EQ(rig.device.last().eigen().norm(), 0.0);
  EXPECT_EQ(loop.lateness().count(), ticks);
  EXPECT_EQ(loop.compute().count(), ticks);
  // And again.
  loop.start();
  wait_for_ticks(rig.servo, ticks + 20);
  loop.stop();
  EXPECT_GT(rig.servo.tick_count(), ticks);
}

TEST(HapticLoop, HandsOverBothWaysBesideWritersAndReaders) {
  Rig rig;
  HapticLoop loop(rig.servo, rig.clock, quiet());
  std::atomic<bool> go{true};
  // Frames and reports in, as fast as they come.
  std::jthread camera([&] {
    long index = 0;
    while (go.load()) {
      ContactModel model;
      model.time_s = rig.clock.now_s();
      model.frame_index = index++;
      model.valid = true;
      model.state = CellState::kContact;
      model.push = PlainVector3(1.0, 0.0, 0.0);
      model.force_uN = PlainVector3(-2.0, 0.0, 0.0);
      model.stiffness_uN_per_um = 0.1;
      model.depth_um = 10.0;
      rig.contact.publish(model);
      std::this_thread::sleep_for(200us);
    }
  });
  std::jthread manipulator([&] {
    while (go.load()) {
      PipetteState state;
      state.known = true;
      state.time_s = rig.clock.now_s();
      if (rig.command.refresh()) state.tip_um = rig.command.value().tip_um;
      rig.pipette.publish(state);
      std::this_thread::sleep_for(300us);
    }
  });
  // Records, events and the display's slot out.
  std::uint64_t drained = 0;
  bool contact_felt = false, in_order = true;
  std::jthread drain([&] {
    double last_s = -1.0;
    while (go.load()) {
      while (const auto record = rig.servo.records().pop()) {
        in_order = in_order && record->time_s >= last_s;
        last_s = record->time_s;
        contact_felt = contact_felt || record->contact_force_uN.x < 0.0;
        ++drained;
      }
      while (rig.servo.events().pop()) {
      }
      rig.servo.newest().refresh();
      std::this_thread::sleep_for(1ms);
    }
  });
  loop.start();
  // Settings, stop and release from this thread.
  for (int k = 0; k < 40; ++k) {
    HapticSettings settings = rig.settings;
    settings.fixtures.stop.enabled = k % 2 == 0;
    rig.servo.set(settings);
    if (k == 20) rig.servo.emergency_stop();
    if (k == 25) rig.servo.release_emergency_stop();
    std::this_thread::sleep_for(5ms);
  }
  wait_for_ticks(rig.servo, 150);
  loop.stop();
  go.store(false);
  camera.join();
  manipulator.join();
  drain.join();
  EXPECT_TRUE(in_order);
  EXPECT_TRUE(contact_felt);
  EXPECT_GT(drained, 0U);
  EXPECT_EQ(rig.device.last().eigen().norm(), 0.0);
}

TEST(HapticLoop, SettingsTheDeviceCanNotHoldAreRefusedWhileItRuns) {
  Rig rig;
  HapticLoop loop(rig.servo, rig.clock, quiet());
  loop.start();
  HapticSettings settings = rig.settings;
  settings.force_scale_N_per_uN *= 10.0;
  EXPECT_THROW(rig.servo.set(settings), UsageError);
  loop.stop();
}

TEST(HapticLoop, WhatTheSystemGrantedIsReported) {
  Rig rig;
  HapticLoop loop(rig.servo, rig.clock, quiet());
  loop.start();
  const RealTimeOutcome outcome = loop.real_time();
  loop.stop();
  EXPECT_NE(outcome.fifo, outcome.refused.find("SCHED_FIFO") != std::string::npos);
  EXPECT_FALSE(outcome.text().empty());

  // Enforced, it runs or it says why it doesn't.
  HapticLoopOptions options = quiet();
  options.policy = RealTimePolicy::kEnforce;
  HapticLoop strict(rig.servo, rig.clock, options);
  if (outcome.fifo) {
    strict.start();
    EXPECT_TRUE(strict.running());
  } else {
    EXPECT_THROW(strict.start(), DeviceError);
    EXPECT_FALSE(strict.running());
  }
}

TEST(HapticLoop, OptionsOutOfRangeAreRefused) {
  Rig rig;
  EXPECT_THROW(HapticLoop(rig.servo, rig.clock, {.period_s = 0.0}), UsageError);
  EXPECT_THROW(HapticLoop(rig.servo, rig.clock, {.priority = 100}), UsageError);
}

}  // namespace
}  // namespace pellucida
