#include "pellucida/teleoperation/ManipulatorStage.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/SimulatedInjector.h"

namespace pellucida {
namespace {

/// A manipulator that notes its commands, and is lost on request.
class NotedManipulator final : public Manipulator {
 public:
  void open() override {
    if (!there) throw DeviceError("noted manipulator: not there");
    open_ = true;
  }
  void close() noexcept override { open_ = false; }
  bool is_open() const noexcept override { return open_; }
  const ManipulatorSpecification& specification() const noexcept override { return specification_; }
  void command(const PipetteCommand& command, double) override {
    if (!there) throw DeviceError("noted manipulator: unplugged");
    commands.push_back(command);
  }
  PipetteState state(double now_s) override {
    if (!there) throw DeviceError("noted manipulator: unplugged");
    PipetteState state;
    state.time_s = now_s;
    state.known = true;
    return state;
  }

  bool there = true;
  std::vector<PipetteCommand> commands;

 private:
  bool open_ = false;
  ManipulatorSpecification specification_;
};

PipetteCommand inject_at(double x_um) {
  PipetteCommand command;
  command.tip_um.x = x_um;
  command.max_speed_um_per_s = 100.0;
  command.inject = true;
  return command;
}

TEST(ManipulatorStage, HandsOnTheNewestCommandOnce) {
  NotedManipulator manipulator;
  manipulator.open();
  ManualClock clock;
  ManipulatorStage stage(manipulator, clock);
  stage.turn();
  EXPECT_TRUE(manipulator.commands.empty());
  stage.commands().publish(inject_at(1.0));
  stage.commands().publish(inject_at(2.0));
  stage.turn();
  clock.advance(0.01);
  stage.turn();
  ASSERT_EQ(manipulator.commands.size(), 1u);
  EXPECT_EQ(manipulator.commands[0].tip_um.x, 2.0);
  ASSERT_TRUE(stage.states().refresh());
  EXPECT_TRUE(stage.states().value().known);
  EXPECT_EQ(stage.newest_state().time_s, 0.01);
}

TEST(ManipulatorStage, HoldsThePipetteWhenTheLoopFallsSilent) {
  NotedManipulator manipulator;
  manipulator.open();
  ManualClock clock;
  ManipulatorStage stage(manipulator, clock);
  stage.commands().publish(inject_at(1.0));
  stage.turn();
  for (int i = 0; i < 30; ++i) {
    clock.advance(0.01);
    stage.turn();
  }
  ASSERT_EQ(manipulator.commands.size(), 2u);
  EXPECT_EQ(manipulator.commands[1].max_speed_um_per_s, 0.0);
  EXPECT_FALSE(manipulator.commands[1].inject);
  EXPECT_EQ(stage.counts().hold_count, 1u);
  stage.commands().publish(inject_at(3.0));
  stage.turn();
  EXPECT_EQ(manipulator.commands.back().max_speed_um_per_s, 100.0);
}

TEST(ManipulatorStage, HoldsThePipetteForNumbersNobodyCanMean) {
  NotedManipulator manipulator;
  manipulator.open();
  ManualClock clock;
  ManipulatorStage stage(manipulator, clock);
  stage.commands().publish(inject_at(1.0));
  stage.turn();
  stage.commands().publish(inject_at(std::numeric_limits<double>::quiet_NaN()));
  stage.turn();
  ASSERT_EQ(manipulator.commands.size(), 2u);
  EXPECT_EQ(manipulator.commands[1].max_speed_um_per_s, 0.0);
  EXPECT_EQ(manipulator.commands[1].tip_um.x, 0.0);
}

TEST(ManipulatorStage, SaysWhenTheDeviceIsLostAndTakesItBackWithoutCatchingUp) {
  NotedManipulator manipulator;
  manipulator.open();
  ManualClock clock;
  ManipulatorStage stage(manipulator, clock);
  stage.commands().publish(inject_at(1.0));
  stage.turn();
  manipulator.there = false;
  clock.advance(0.01);
  stage.turn();
  EXPECT_FALSE(stage.newest_state().known);
  EXPECT_EQ(stage.counts().lost_count, 1u);
  EXPECT_EQ(stage.counts().last_fault, "noted manipulator: unplugged");

  // Commands go on coming; opening is tried once a second only.
  for (int i = 0; i < 250; ++i) {
    clock.advance(0.01);
    stage.commands().publish(inject_at(50.0 + i));
    if (i == 150) manipulator.there = true;
    const std::size_t before = manipulator.commands.size();
    stage.turn();
    if (stage.counts().reopen_count == 1) {
      // The turn that opens it hands nothing on.
      EXPECT_EQ(manipulator.commands.size(), before);
      break;
    }
  }
  EXPECT_EQ(stage.counts().reopen_count, 1u);
  EXPECT_EQ(manipulator.commands.size(), 1u);
  EXPECT_TRUE(stage.newest_state().known);
  stage.turn();
  EXPECT_EQ(manipulator.commands.size(), 1u);
  stage.commands().publish(inject_at(7.0));
  stage.turn();
  EXPECT_EQ(manipulator.commands.back().tip_um.x, 7.0);
}

TEST(ManipulatorStage, RunsOnItsOwnThreadAndClosesAtTheEnd) {
  SimulatedInjector injector;
  SteadyClock clock;
  ManipulatorStage stage(injector, clock);
  stage.start();
  PipetteState state;
  // The pipette arrives, however long the machine takes.
  while (!(state.known && state.tip_um.x > 4.9)) {
    stage.commands().publish(inject_at(5.0));
    if (stage.states().refresh()) state = stage.states().value();
    std::this_thread::yield();
  }
  stage.stop();
  EXPECT_FALSE(injector.is_open());
  EXPECT_GT(stage.counts().command_count, 0u);
  EXPECT_EQ(stage.counts().lost_count, 0u);
}

TEST(ManipulatorStage, DoesNotStartWithoutADevice) {
  NotedManipulator manipulator;
  manipulator.there = false;
  ManualClock clock;
  ManipulatorStage stage(manipulator, clock);
  EXPECT_THROW(stage.start(), DeviceError);
  EXPECT_THROW(ManipulatorStage(manipulator, clock, {.rate_Hz = 0.0}), UsageError);
}

}  // namespace
}  // namespace pellucida
