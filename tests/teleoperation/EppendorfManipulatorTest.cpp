#include "pellucida/teleoperation/EppendorfManipulator.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/ManipulatorStage.h"
#include "teleoperation/PseudoTerminal.h"

namespace pellucida {
namespace {

/// The far end: answers as the manual says, moves at once, and can misbehave.
class Emulator {
 public:
  enum class Mood { kWell, kMute, kGarbage, kHalf, kEcho, kMuteOnce, kWrongCode, kShortPosition };

  std::string answer(const std::string& line) {
    std::lock_guard lock(mutex_);
    heard_.push_back(line);
    const std::string right = right_answer(line);
    switch (mood_) {
      case Mood::kWell:
        return right;
      case Mood::kMute:
        return {};
      case Mood::kGarbage:
        return "\xff\x80 what?\r";
      case Mood::kHalf:
        return right.substr(0, right.size() / 2);
      case Mood::kEcho:
        return line + "\r\n" + right;
      case Mood::kMuteOnce:
        mood_ = Mood::kWell;
        return {};
      case Mood::kWrongCode:
        return "A099\r";
      case Mood::kShortPosition:
        return line == "C010" ? "A010 1 2\r" : right;
    }
    return {};
  }

  void set(Mood mood) {
    std::lock_guard lock(mutex_);
    mood_ = mood;
  }
  void set_switches(long switches) {
    std::lock_guard lock(mutex_);
    switches_ = switches;
  }
  void set_microsteps(long per_um) {
    std::lock_guard lock(mutex_);
    microsteps_per_um_ = per_um;
  }
  void place(const std::array<long, 3>& position) {
    std::lock_guard lock(mutex_);
    position_ = position;
  }
  std::vector<std::string> heard() {
    std::lock_guard lock(mutex_);
    return std::exchange(heard_, {});
  }

 private:
  std::string right_answer(const std::string& line) {
    const std::string code = line.substr(0, 4);
    long p[3], v[3];
    if (code == "C001") return "A001 5181 V1.04\r";
    if (code == "C010" || code == "C009") {
      char text[120];
      const long unit = code == "C009" ? microsteps_per_um_ : 1;
      std::snprintf(text, sizeof text, "A%s %ld%+ld%+ld %ld\r", code.c_str() + 1, unit * position_[0],
                    unit * position_[1], unit * position_[2], switches_);
      return text;
    }
    if (code == "C012" || code == "C011") {
      if (std::sscanf(line.c_str() + 4, "%ld%ld%ld%ld%ld%ld", p, p + 1, p + 2, v, v + 1, v + 2) != 6) return "error\r";
      for (int axis = 0; axis < 3; ++axis) {
        if (v[axis] > 0) position_[axis] = p[axis];
      }
    }
    return "A" + code.substr(1) + "\r";
  }

  std::mutex mutex_;
  Mood mood_ = Mood::kWell;
  std::array<long, 3> position_{};
  long switches_ = 0;
  long microsteps_per_um_ = 1;
  std::vector<std::string> heard_;
};

PipetteCommand go_to(double x_um, double y_um, double z_um, double speed_um_per_s = 100.0) {
  PipetteCommand command;
  command.tip_um = {x_um, y_um, z_um};
  command.max_speed_um_per_s = speed_um_per_s;
  return command;
}

std::string fault_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const DeviceError& fault) {
    return fault.what();
  }
  return "nothing was thrown";
}

/// Opens it, however often a busy machine is later than a short deadline.
void open_patiently(EppendorfManipulator& manipulator) {
  while (!manipulator.is_open()) {
    try {
      manipulator.open();
    } catch (const DeviceError&) {
    }
  }
}

class EppendorfManipulatorTest : public testing::Test {
 protected:
  EppendorfManipulatorTest() {
    line_.serve([this](const std::string& line) { return emulator_.answer(line); });
    options_.port = line_.path();
    // Long, for a busy machine; only tests in which no answer comes shorten it.
    options_.answer_timeout_s = 10.0;
  }

  Emulator emulator_;
  PseudoTerminal line_;
  EppendorfOptions options_;
};

TEST_F(EppendorfManipulatorTest, OpensAsksTheVersionAndTakesRemoteControl) {
  EppendorfManipulator manipulator(options_);
  manipulator.open();
  EXPECT_TRUE(manipulator.is_open());
  EXPECT_EQ(manipulator.version(), "5181 V1.04");
  EXPECT_EQ(emulator_.heard(), (std::vector<std::string>{"C001", "C004", "C010"}));
  manipulator.close();
  EXPECT_EQ(emulator_.heard(), (std::vector<std::string>{"C008", "C005"}));
}

TEST_F(EppendorfManipulatorTest, TellsOfItselfWithoutBeingMoved) {
  emulator_.place({1000, -2500, 30});
  emulator_.set_microsteps(25);
  EppendorfIdentity identity = ask_identity(options_.port, 10.0);
  EXPECT_EQ(identity.version, "5181 V1.04");
  EXPECT_EQ(identity.micrometres.coordinates[1], -2500);
  EXPECT_NEAR(identity.microsteps_per_um, 25.0, 1e-12);
  EXPECT_EQ(emulator_.heard(), (std::vector<std::string>{"C001", "C009", "C010"}));
  emulator_.place({99, 0, 0});
  EXPECT_EQ(ask_identity(options_.port, 10.0).microsteps_per_um, 0.0);
}

TEST_F(EppendorfManipulatorTest, GoesStraightInTheFrameOfTheImage) {
  EppendorfManipulator manipulator(options_);
  manipulator.open();
  manipulator.state(0.0);
  emulator_.heard();
  // Down in the image is forwards on the bench, which is minus y of the device.
  manipulator.command(go_to(30.0, 40.0, 0.0), 0.0);
  EXPECT_EQ(emulator_.heard(), (std::vector<std::string>{"C012 30 -40 0 60 80 0"}));
  PipetteState state = manipulator.state(0.1);
  EXPECT_NEAR(state.tip_um.x, 30.0, 1e-9);
  EXPECT_NEAR(state.tip_um.y, 40.0, 1e-9);
  EXPECT_NEAR(state.velocity_um_per_s.x, 300.0, 1e-6);
  EXPECT_TRUE(state.known);
  EXPECT_TRUE(state.moving);
  EXPECT_FALSE(manipulator.state(0.2).moving);
  // The same again says nothing new.
  emulator_.heard();
  manipulator.command(go_to(30.0, 40.0, 0.0), 0.2);
  EXPECT_TRUE(emulator_.heard().empty());
}

TEST_F(EppendorfManipulatorTest, IsGivenTheTipsPosition) {
  emulator_.place({1000, 2000, 3000});
  EppendorfManipulator manipulator(options_);
  manipulator.open();
  manipulator.register_tip({120.0, 90.0, 0.0});
  EXPECT_NEAR(manipulator.state(0.0).tip_um.y, 90.0, 1e-9);
  manipulator.command(go_to(121.0, 92.0, 3.0), 0.1);
  const PipetteState state = manipulator.state(0.1);
  EXPECT_NEAR(state.tip_um.x, 121.0, 1e-9);
  EXPECT_NEAR(state.tip_um.y, 92.0, 1e-9);
  EXPECT_NEAR(state.tip_um.z, 3.0, 1e-9);
  EXPECT_EQ(emulator_.heard().back(), "C010");
}

TEST_F(EppendorfManipulatorTest, GoesInMicrostepsWhenTheirSizeIsKnown) {
  options_.microsteps_per_um = 25.0;
  EppendorfManipulator manipulator(options_);
  manipulator.open();
  emulator_.heard();
  manipulator.command(go_to(0.2, 0.0, 0.0, 10.0), 0.0);
  EXPECT_EQ(emulator_.heard(), (std::vector<std::string>{"C011 5 0 0 250 0 0"}));
  EXPECT_NEAR(manipulator.state(0.1).tip_um.x, 0.2, 1e-9);
  EXPECT_NEAR(manipulator.specification().resolution_um, 0.04, 1e-12);
}

TEST_F(EppendorfManipulatorTest, StopsAtOnceOnceAndStaysUntilReleased) {
  EppendorfManipulator manipulator(options_);
  manipulator.open();
  emulator_.heard();
  PipetteCommand stop;
  stop.stop = true;
  manipulator.command(stop, 0.0);
  manipulator.command(stop, 0.1);
  EXPECT_EQ(emulator_.heard(), (std::vector<std::string>{"C008"}));
  EXPECT_TRUE(manipulator.state(0.1).stopped);
  manipulator.command(go_to(5.0, 0.0, 0.0), 0.2);
  EXPECT_FALSE(manipulator.state(0.3).stopped);
}

TEST_F(EppendorfManipulatorTest, StandsStillForSpeedZeroAndKeepsToItsTravel) {
  options_.travel_um = 50.0;
  EppendorfManipulator manipulator(options_);
  manipulator.open();
  manipulator.command(go_to(80.0, 0.0, 0.0), 0.0);
  PipetteState state = manipulator.state(0.1);
  EXPECT_NEAR(state.tip_um.x, 50.0, 1e-9);
  EXPECT_TRUE(state.at_limit);
  emulator_.heard();
  manipulator.command(go_to(0.0, 0.0, 0.0, 0.0), 0.2);
  EXPECT_EQ(emulator_.heard(), (std::vector<std::string>{"C008"}));
  manipulator.command(go_to(10.0, 0.0, 0.0), 0.3);
  EXPECT_FALSE(manipulator.state(0.4).at_limit);
  // A position that is not a number is not a target: it stays.
  emulator_.heard();
  manipulator.command(go_to(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0), 0.4);
  EXPECT_EQ(emulator_.heard(), (std::vector<std::string>{"C008"}));
  emulator_.set_switches(2);
  EXPECT_TRUE(manipulator.state(0.5).at_limit);
}

TEST_F(EppendorfManipulatorTest, EchoAndASingleLostAnswerDoNoHarm) {
  options_.answer_timeout_s = 1.0;
  emulator_.set(Emulator::Mood::kEcho);
  EppendorfManipulator manipulator(options_);
  open_patiently(manipulator);
  EXPECT_GT(manipulator.stray_line_count(), 0u);
  emulator_.set(Emulator::Mood::kMuteOnce);
  EXPECT_TRUE(manipulator.state(0.0).known);
  EXPECT_TRUE(manipulator.is_open());
}

TEST_F(EppendorfManipulatorTest, SaysWhatCameInsteadOfAnAnswer) {
  options_.answer_timeout_s = 0.05;
  const std::pair<Emulator::Mood, std::string> cases[] = {{Emulator::Mood::kMute, "no answer to C010"},
                                                          {Emulator::Mood::kGarbage, "\"?? what?\""},
                                                          {Emulator::Mood::kHalf, "no answer to C010"},
                                                          {Emulator::Mood::kWrongCode, "\"A099\""},
                                                          {Emulator::Mood::kShortPosition, "\"1 2\""}};
  for (const auto& [mood, expected] : cases) {
    emulator_.set(Emulator::Mood::kWell);
    EppendorfManipulator manipulator(options_);
    open_patiently(manipulator);
    emulator_.set(mood);
    const std::string fault = fault_of([&] { manipulator.state(0.0); });
    EXPECT_NE(fault.find(expected), std::string::npos) << fault;
    EXPECT_NE(fault.find(line_.path()), std::string::npos) << fault;
    EXPECT_FALSE(manipulator.is_open());
    emulator_.set(Emulator::Mood::kWell);
  }
}

TEST_F(EppendorfManipulatorTest, ComesBackAfterItWasSilent) {
  options_.answer_timeout_s = 0.2;
  EppendorfManipulator manipulator(options_);
  open_patiently(manipulator);
  emulator_.set(Emulator::Mood::kMute);
  EXPECT_THROW(manipulator.state(0.0), DeviceError);
  EXPECT_THROW(manipulator.open(), DeviceError);
  EXPECT_FALSE(manipulator.is_open());
  emulator_.set(Emulator::Mood::kWell);
  open_patiently(manipulator);
  EXPECT_EQ(manipulator.version(), "5181 V1.04");
}

TEST_F(EppendorfManipulatorTest, SaysWhenThePlugIsPulled) {
  EppendorfManipulator manipulator(options_);
  manipulator.open();
  line_.unplug();
  const std::string fault = fault_of([&] { manipulator.state(0.0); });
  EXPECT_NE(fault.find("is gone"), std::string::npos) << fault;
  EXPECT_FALSE(manipulator.is_open());
  const std::string again = fault_of([&] { manipulator.open(); });
  EXPECT_NE(again.find("there is no " + options_.port), std::string::npos) << again;
}

TEST_F(EppendorfManipulatorTest, TheStageTakesALossAndAReturn) {
  options_.answer_timeout_s = 0.1;
  EppendorfManipulator manipulator(options_);
  open_patiently(manipulator);
  ManualClock clock;
  ManipulatorStage stage(manipulator, clock);
  emulator_.set(Emulator::Mood::kMute);
  stage.turn();
  EXPECT_FALSE(stage.newest_state().known);
  EXPECT_NE(stage.counts().last_fault.find("no answer"), std::string::npos);
  emulator_.set(Emulator::Mood::kWell);
  while (stage.counts().reopen_count == 0) {
    clock.advance(2.0);
    stage.turn();
  }
  while (!stage.newest_state().known) {
    clock.advance(2.0);
    stage.turn();
  }
  EXPECT_GE(stage.counts().lost_count, 1u);
}

TEST(SerialPort, SaysWhyItCannotBeOpened) {
  const std::string missing = fault_of([] { SerialPort("/dev/ttyPELLUCIDA", 19200); });
  EXPECT_NE(missing.find("there is no /dev/ttyPELLUCIDA"), std::string::npos) << missing;
  const std::string other = fault_of([] { SerialPort("/dev/null", 19200); });
  EXPECT_NE(other.find("no serial port"), std::string::npos) << other;
}

TEST(EppendorfOptions, AreCheckedBeforeAnythingMoves) {
  EppendorfOptions options;
  options.axes[2] = options.axes[0];
  EXPECT_THROW(EppendorfManipulator flat(options), UsageError);
  options = {};
  options.max_speed_um_per_s = 0.0;
  EXPECT_THROW(EppendorfManipulator slow(options), UsageError);
  EXPECT_THROW(EppendorfManipulator({}).command({}, 0.0), DeviceError);
}

}  // namespace
}  // namespace pellucida
