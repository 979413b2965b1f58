#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <string_view>

#include "pellucida/operation/OperatorConsole.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "support/WaitUntil.h"

namespace pellucida {

/// A console on the virtual microscope, its window's tick in the test's hands.
class OperatorConsoleTest : public testing::Test {
 protected:
  OperatorConsoleTest() { run_.start(); }
  ~OperatorConsoleTest() override { run_.stop(); }

  bool tick_until(const std::function<bool()>& condition) {
    return test::wait_until([&] {
      console_.update();
      return condition();
    });
  }
  bool tick_until_state(HandState state) {
    return tick_until([&] { return console_.status().tick.hand_state == state; });
  }
  void choose(std::string_view name) { console_.choose(console_.find_hand(name).value()); }
  double tip_x_um() { return console_.status().tick.tip_um.x; }

  VirtualInjectionSetup setup_{"injection"};
  LiveRun run_{setup_.make_microscope(Pace::kWallClock), {}};
  OperatorConsole console_{run_, setup_.injector(), &setup_.needle(), {.rest_s = 0.5}};
};

}  // namespace pellucida
