#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "pellucida/teleoperation/MouseHand.h"
#include "pellucida/teleoperation/OpenHapticsHand.h"
#include "pellucida/teleoperation/PolledHand.h"
#include "pellucida/teleoperation/TeleoperationMap.h"
#include "tracking/AllocationCounter.h"

// What the 1 kHz thread calls neither asks for memory nor may throw.

namespace pellucida {
namespace {

static_assert(noexcept(std::declval<TeleoperationMap&>().update({}, 0.0)));
static_assert(noexcept(std::declval<TeleoperationMap&>().engage({}, {})));
static_assert(noexcept(std::declval<MouseHand&>().show({})));
static_assert(noexcept(std::declval<PolledHand&>().write({})));
static_assert(noexcept(std::declval<OpenHapticsHand&>().write({})));

TEST(Tick, OfMapAndMouseAsksForNoMemory) {
  TeleoperationMap map;
  MouseHand mouse;
  HandSample hand;
  mouse.read(0.0, hand);
  map.engage(hand, {100.0, 100.0, 0.0});
  TeleoperationSettings settings;
  TouchCue cue;
  cue.contact = true;
  cue.stiffness_N_per_m = 50.0;
  double sum_um = 0.0;

  const test::AllocationCounter counter;
  for (int tick = 1; tick <= 10000; ++tick) {
    mouse.move_px(std::sin(tick * 0.01), 1.0);
    if (tick % 500 == 0) mouse.press(kClutch);
    if (tick % 500 == 100) mouse.release(kClutch);
    if (tick % 1000 == 0) {
      settings.control = settings.control == TeleoperationSettings::Control::kRate
                             ? TeleoperationSettings::Control::kPosition
                             : TeleoperationSettings::Control::kRate;
      map.request(settings);
    }
    cue.force_N = {std::cos(tick * 0.02), 0.3, 0.0};
    mouse.show(cue);
    mouse.read(tick * 0.001, hand);
    sum_um += map.update(hand, 0.001).tip_um.x + map.centring_force_N(hand).x;
    mouse.write({});
  }
  EXPECT_EQ(counter.count(), 0U);
  EXPECT_TRUE(std::isfinite(sum_um));
}

}  // namespace
}  // namespace pellucida
