#include <gtest/gtest.h>

#include "pellucida/simulation/CommandedNeedle.h"
#include "pellucida/simulation/SimulatedHand.h"
#include "tracking/AllocationCounter.h"

namespace pellucida {
namespace {

TEST(SpecimenRealTime, MovingTheNeedleAllocatesNothing) {
  CommandedNeedle needle(parse_scenario(R"({"puncture": {"enabled": true, "spread_ratio": 0.1}})", "test"));
  needle.move(0, needle.start_um());
  double felt = 0;
  const test::AllocationCounter counter;
  for (int k = 0; k < 10000; ++k) {
    const double depth = k < 7000 ? -5 + 0.01 * k : 65 - 0.025 * (k - 7000);
    const auto& moment = needle.move(1e-3 * k, needle.force().tip_at(6 * (k % 100) / 100.0, depth), {},
                                     k > 6000 ? 1e-3 * (k - 6000) : 0);
    felt += moment.reply.axial_force_uN + needle.force().at(moment.tip_um).energy_uN_um;
    needle.at(1e-3 * k);
  }
  EXPECT_EQ(counter.count(), 0u);
  EXPECT_GT(felt, 0);
}

TEST(SpecimenRealTime, TheHandAllocatesNothing) {
  OperatorPlan plan;
  plan.target_um = {-60, 0, 0};
  SimulatedHand hand(OperatorOptions{}, plan, ArmOptions{}, 4);
  HandSample sample;
  hand.read(0, sample);
  const test::AllocationCounter counter;
  for (int k = 1; k <= 10000; ++k) {
    if (k % 33 == 0) hand.see({1e-3 * k, {1e4 * sample.position_m.x, 0, 0}, true, k > 4000});
    hand.write({0.1, 0, 0});
    hand.read(1e-3 * k, sample);
  }
  EXPECT_EQ(counter.count(), 0u);
  EXPECT_GT(hand.simulated_operator().submovement_count(), 0);
}

}  // namespace
}  // namespace pellucida
