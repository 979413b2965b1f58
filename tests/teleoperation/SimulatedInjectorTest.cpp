#include "pellucida/teleoperation/SimulatedInjector.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

PipetteCommand go_to(double x_um, double y_um = 0.0, double z_um = 0.0, double speed_um_per_s = 1000.0) {
  PipetteCommand command;
  command.tip_um = {x_um, y_um, z_um};
  command.max_speed_um_per_s = speed_um_per_s;
  return command;
}

SimulatedInjectorOptions ideal() {
  SimulatedInjectorOptions options;
  options.backlash_um = 0.0;
  options.resolution_um = 0.0;
  options.latency_s = 0.0;
  return options;
}

TEST(SimulatedInjector, ArrivesExactlyAndDoesNotOvershoot) {
  SimulatedInjector injector(ideal());
  injector.open();
  injector.command(go_to(100.0, -30.0, 5.0), 0.0);
  double furthest_um = 0.0;
  for (int i = 0; i < 1000; ++i) {
    injector.advance(0.001);
    furthest_um = std::max(furthest_um, injector.pose().tip_um.x);
  }
  EXPECT_DOUBLE_EQ(injector.pose().tip_um.x, 100.0);
  EXPECT_DOUBLE_EQ(injector.pose().tip_um.y, -30.0);
  EXPECT_DOUBLE_EQ(injector.pose().tip_um.z, 5.0);
  EXPECT_LE(furthest_um, 100.0 + 1e-6);
  EXPECT_FALSE(injector.state(1.0).moving);
}

TEST(SimulatedInjector, KeepsToSpeedAndAcceleration) {
  SimulatedInjector injector(ideal());
  injector.open();
  injector.command(go_to(600.0, 800.0), 0.0);
  Eigen::Vector3d last_um = injector.pose().tip_um.eigen();
  Eigen::Vector3d last_velocity = Eigen::Vector3d::Zero();
  double fastest = 0.0;
  for (int i = 0; i < 2000; ++i) {
    injector.advance(0.001);
    const Eigen::Vector3d now_um = injector.pose().tip_um.eigen();
    const Eigen::Vector3d velocity = (now_um - last_um) / 0.001;
    fastest = std::max(fastest, velocity.norm());
    ASSERT_LE((velocity - last_velocity).cwiseAbs().maxCoeff(), 20000.0 * 0.001 + 1e-3) << "tick " << i;
    last_um = now_um;
    last_velocity = velocity;
  }
  EXPECT_NEAR(fastest, 1000.0, 1e-6);
}

TEST(SimulatedInjector, StartsOnlyAfterItsLatency) {
  SimulatedInjectorOptions options = ideal();
  options.latency_s = 0.05;
  SimulatedInjector injector(options);
  injector.open();
  injector.command(go_to(100.0), 0.0);
  injector.advance(0.049);
  EXPECT_EQ(injector.pose().tip_um.x, 0.0);
  injector.advance(0.01);
  EXPECT_GT(injector.pose().tip_um.x, 0.0);
}

TEST(SimulatedInjector, StopsAtTheTravelLimitAndTells) {
  SimulatedInjectorOptions options = ideal();
  options.upper_um = {50.0, 50.0, 50.0};
  SimulatedInjector injector(options);
  injector.open();
  injector.command(go_to(80.0), 0.0);
  const PipetteState state = injector.state(2.0);
  EXPECT_DOUBLE_EQ(state.tip_um.x, 50.0);
  EXPECT_TRUE(state.at_limit);
  injector.command(go_to(40.0), 2.0);
  EXPECT_FALSE(injector.state(3.0).at_limit);
}

TEST(SimulatedInjector, TipLagsTheMotorByThePlayWhenItTurnsBack) {
  SimulatedInjectorOptions options = ideal();
  options.backlash_um = 2.0;
  SimulatedInjector injector(options);
  injector.open();
  injector.command(go_to(10.0), 0.0);
  EXPECT_DOUBLE_EQ(injector.state(1.0).tip_um.x, 10.0);
  EXPECT_DOUBLE_EQ(injector.pose().tip_um.x, 9.0);
  // The first 2 um back are play: the report moves, the tip does not.
  injector.command(go_to(8.5), 1.0);
  EXPECT_DOUBLE_EQ(injector.state(2.0).tip_um.x, 8.5);
  EXPECT_DOUBLE_EQ(injector.pose().tip_um.x, 9.0);
  injector.command(go_to(5.0), 2.0);
  injector.state(3.0);
  EXPECT_DOUBLE_EQ(injector.pose().tip_um.x, 6.0);
}

TEST(SimulatedInjector, GoesInSteps) {
  SimulatedInjectorOptions options = ideal();
  options.resolution_um = 0.5;
  SimulatedInjector injector(options);
  injector.open();
  injector.command(go_to(3.3), 0.0);
  EXPECT_DOUBLE_EQ(injector.state(1.0).tip_um.x, 3.5);
}

TEST(SimulatedInjector, EmergencyStopStandsAtOnceAndStays) {
  SimulatedInjectorOptions options = ideal();
  options.latency_s = 0.05;
  SimulatedInjector injector(options);
  injector.open();
  injector.command(go_to(500.0), 0.0);
  const double moving_um = injector.state(0.2).tip_um.x;
  ASSERT_GT(moving_um, 1.0);
  PipetteCommand stop;
  stop.stop = true;
  injector.command(stop, 0.2);
  PipetteState state = injector.state(1.0);
  EXPECT_TRUE(state.stopped);
  EXPECT_FALSE(state.moving);
  EXPECT_DOUBLE_EQ(state.tip_um.x, moving_um);
  injector.command(go_to(500.0), 1.0);
  state = injector.state(3.0);
  EXPECT_FALSE(state.stopped);
  EXPECT_DOUBLE_EQ(state.tip_um.x, 500.0);
}

TEST(SimulatedInjector, DepositsWhileAsked) {
  SimulatedInjector injector(ideal());
  injector.open();
  PipetteCommand command = go_to(0.0);
  command.inject = true;
  injector.command(command, 0.0);
  injector.advance(0.4);
  EXPECT_NEAR(injector.pose().deposited_pl, 2.0, 1e-9);
  command.inject = false;
  injector.command(command, 0.4);
  injector.advance(1.0);
  EXPECT_NEAR(injector.pose().deposited_pl, 2.0, 1e-9);
}

TEST(SimulatedInjector, IsTheSameWhateverTheCrank) {
  SimulatedInjector coarse, fine;
  for (SimulatedInjector* injector : {&coarse, &fine}) {
    injector->open();
    injector->command(go_to(123.0, 45.0, -6.0), 0.0);
  }
  coarse.advance(0.1);
  for (int i = 0; i < 100; ++i) fine.advance(0.001);
  EXPECT_NEAR((coarse.pose().tip_um.eigen() - fine.pose().tip_um.eigen()).norm(), 0.0, 1e-6);
}

TEST(SimulatedInjector, TellsItsFollowerTheTrueTip) {
  InjectorPose seen;
  SimulatedInjectorOptions options = ideal();
  options.backlash_um = 1.0;
  SimulatedInjector injector(options, [&seen](const InjectorPose& pose) { seen = pose; });
  injector.open();
  injector.command(go_to(10.0), 0.0);
  injector.state(1.0);
  EXPECT_DOUBLE_EQ(seen.tip_um.x, 9.5);
  EXPECT_DOUBLE_EQ(seen.time_s, 1.0);
}

TEST(SimulatedInjector, RefusesToMoveWhenClosedAndOptionsThatMeanNothing) {
  SimulatedInjector injector;
  EXPECT_THROW(injector.command(go_to(1.0), 0.0), DeviceError);
  EXPECT_THROW(injector.state(0.0), DeviceError);
  SimulatedInjectorOptions options;
  options.max_speed_um_per_s = 0.0;
  EXPECT_THROW(SimulatedInjector slow(options), UsageError);
  options = {};
  options.start_um = {5000.0, 0.0, 0.0};
  EXPECT_THROW(SimulatedInjector outside(options), UsageError);
}

}  // namespace
}  // namespace pellucida
