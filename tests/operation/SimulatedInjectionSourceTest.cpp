#include "pellucida/operation/SimulatedInjectionSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pellucida/pipeline/BatchRun.h"

namespace pellucida {
namespace {

struct Ran {
  BatchResult measured;
  InjectionOutcome outcome;
  std::optional<InjectionPlan> plan;
  std::vector<HapticRecord> ticks;
  std::vector<LimitEvent> events;
};

Ran run(const SimulatedInjectionOptions& options) {
  SimulatedInjectionSource microscope(options);
  Ran ran;
  ran.measured = run_batch(microscope, {}, [&](const Scene& scene) {
    microscope.see(scene);
    for (const HapticRecord& tick : microscope.take_records()) ran.ticks.push_back(tick);
    for (const LimitEvent& event : microscope.take_events()) ran.events.push_back(event);
  });
  ran.outcome = microscope.outcome();
  ran.plan = microscope.plan();
  return ran;
}

// Approach, indentation, puncture, deposit, removal: the whole way, by what was measured alone.
TEST(SimulatedInjectionSource, AGuidedInjectionGoesFromEndToEnd) {
  const Ran ran = run({});
  ASSERT_TRUE(ran.plan);
  EXPECT_TRUE(ran.outcome.done);
  EXPECT_GT(ran.outcome.deposited_pL, 1.0);
  ASSERT_GT(ran.outcome.puncture_s, 0.0);

  // The force measured before the break against the specimen's own: 2.7 % found, twice that allowed.
  const double measured_uN = ran.measured.peak->measurement.contact_force_uN;
  EXPECT_NEAR(measured_uN, ran.outcome.puncture_force_uN, 0.055 * ran.outcome.puncture_force_uN);
  EXPECT_LT(ran.measured.peak->measurement.time_s, ran.outcome.puncture_s + 1e-9);

  // The manipulator's reports are in the rows and lie within its play and step of the tip that was seen; the tip is
  // misread by 2 um for a frame as the needle begins to move aside.
  int reported = 0, near = 0;
  for (const Measurement& row : ran.measured.rows) {
    if (!std::isfinite(row.manipulator_x_um) || !std::isfinite(row.tip_x_um)) continue;
    EXPECT_NEAR(row.manipulator_x_um, row.tip_x_um, 3.0) << row.frame;
    near += std::abs(row.manipulator_x_um - row.tip_x_um) < 1.5 ? 1 : 0;
    ++reported;
  }
  EXPECT_GT(reported, 100);
  EXPECT_GE(near, reported - 2);

  // In the end the needle is out again and the hand feels nothing.
  EXPECT_EQ(ran.measured.rows.back().state, CellState::kFree);
  EXPECT_LT(ran.ticks.back().contact_force_uN.eigen().norm(), 1e-9);
  // The hand felt the push before, and every tick is there.
  EXPECT_GT(ran.outcome.peak_hand_force_N, 0.1);
  for (std::size_t k = 1; k < ran.ticks.size(); ++k) {
    ASSERT_NEAR(ran.ticks[k].time_s - ran.ticks[k - 1].time_s, 1e-3, 1e-9);
  }
  EXPECT_TRUE(std::any_of(ran.events.begin(), ran.events.end(),
                          [](const LimitEvent& event) { return event.kind == LimitKind::kPuncture && event.begun; }));
}

TEST(SimulatedInjectionSource, TheSameSeedsGiveTheSameInjection) {
  SimulatedInjectionOptions options;
  options.max_duration_s = 3.0;
  const Ran first = run(options);
  const Ran second = run(options);
  ASSERT_EQ(first.ticks.size(), second.ticks.size());
  ASSERT_FALSE(first.ticks.empty());
  EXPECT_EQ(first.ticks.back().tip_um.eigen(), second.ticks.back().tip_um.eigen());
  options.seed = 2;
  EXPECT_NE(first.ticks.back().tip_um.eigen(), run(options).ticks.back().tip_um.eigen());
}

// Operators who see a flat picture lead the tip so that the tracker loses it in the cell's texture and takes it for far
// past the membrane.
TEST(SimulatedInjectionSource, NoPunctureIsReportedBeforeTheMembraneGivesWay) {
  for (const unsigned seed : {1u, 2u}) {
    SimulatedInjectionOptions options;
    options.simulated_operator.modality = Modality::kFlatImage;
    options.seed = seed;
    options.max_duration_s = 3.4;
    const Ran ran = run(options);
    double deepest_uN = 0.0;
    for (const Measurement& row : ran.measured.rows) {
      const bool may_be_punctured = ran.outcome.puncture_s >= 0.0 && row.time_s >= ran.outcome.puncture_s - 1e-9;
      if (!may_be_punctured) {
        ASSERT_NE(row.state, CellState::kPunctured) << "seed " << seed << ", " << row.time_s << " s";
      }
      if (std::isfinite(row.contact_force_uN)) deepest_uN = std::max(deepest_uN, row.contact_force_uN);
    }
    // The contact goes on: well beyond where it was taken for a puncture.
    EXPECT_GT(deepest_uN, 1.0) << seed;
  }
}

TEST(SimulatedInjectionSource, WithoutHapticsNothingIsFelt) {
  SimulatedInjectionOptions options;
  options.simulated_operator.modality = Modality::kSpace;
  options.max_duration_s = 4.0;
  const Ran ran = run(options);
  ASSERT_FALSE(ran.ticks.empty());
  EXPECT_TRUE(std::any_of(ran.measured.rows.begin(), ran.measured.rows.end(),
                          [](const Measurement& row) { return row.state == CellState::kContact; }));
  const auto felt = std::max_element(ran.ticks.begin(), ran.ticks.end(), [](const auto& a, const auto& b) {
    return a.hand_force_N.eigen().norm() < b.hand_force_N.eigen().norm();
  });
  // The frame catches the membrane half-way back and counts as a contact: until the next one the limit of depth acts.
  EXPECT_LT(felt->hand_force_N.eigen().norm(), 0.05)
      << "at " << felt->time_s << " s, the cell's force " << felt->contact_force_uN.eigen().norm() << " uN";
}

}  // namespace
}  // namespace pellucida
