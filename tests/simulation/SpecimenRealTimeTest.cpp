#include <gtest/gtest.h>

#include "pellucida/simulation/CommandedNeedle.h"
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

}  // namespace
}  // namespace pellucida
