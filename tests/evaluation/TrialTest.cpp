#include "pellucida/evaluation/Trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "TrialDraw.h"
#include "pellucida/core/Error.h"
#include "pellucida/evaluation/TrialSeries.h"
#include "pellucida/evaluation/TrialSummary.h"

namespace pellucida {
namespace {

const TrialScene& scene() {
  static const TrialScene one;
  return one;
}

std::string rows_of(std::span<const TrialOutcome> outcomes) {
  std::ostringstream text;
  write_trials_csv(text, outcomes);
  return text.str();
}

/// Thirty simulated operators in all four modalities, run once for all cases.
const std::vector<TrialOutcome>& thirty() {
  static const std::vector<TrialOutcome> outcomes = [] {
    SeriesOptions options;
    options.trials = 30;
    options.jobs = 2;
    return run_series(scene(), options);
  }();
  return outcomes;
}

double mean_of(Modality modality, double TrialOutcome::*value) {
  std::vector<double> values;
  for (const TrialOutcome& outcome : thirty())
    if (outcome.modality == modality) values.push_back(outcome.*value);
  return estimate(values).mean;
}

TEST(Trial, SameSeedSameOutcomeWhateverTheThreads) {
  SeriesOptions options;
  options.trials = 3;
  options.jobs = 1;
  const std::string alone = rows_of(run_series(scene(), options));
  options.jobs = 4;
  EXPECT_EQ(rows_of(run_series(scene(), options)), alone);
  options.seed = 100;
  EXPECT_NE(rows_of(run_series(scene(), options)), alone);
}

TEST(Trial, GuideCutsTheLateralErrorAtLeastFivefold) {
  const double guided_um = mean_of(Modality::kSpaceAndFixture, &TrialOutcome::lateral_rms_um);
  EXPECT_GT(guided_um, 0.0);
  EXPECT_LT(5.0 * guided_um, mean_of(Modality::kSpaceAndHaptics, &TrialOutcome::lateral_rms_um));
  EXPECT_LT(5.0 * guided_um, mean_of(Modality::kSpace, &TrialOutcome::lateral_rms_um));
  EXPECT_LT(5.0 * guided_um, mean_of(Modality::kFlatImage, &TrialOutcome::lateral_rms_um));
}

TEST(Trial, HapticsLowerTheApproachSpeed) {
  for (const auto value : {&TrialOutcome::peak_approach_um_per_s, &TrialOutcome::mean_approach_um_per_s}) {
    const Estimate change = paired_difference(thirty(), Modality::kSpace, Modality::kSpaceAndHaptics, value);
    EXPECT_EQ(change.count, 30);
    EXPECT_LT(change.upper, 0.0);
  }
}

// What the arm does by itself, without an operator who slows: the felt force moves it.
TEST(Trial, TheArmAloneYieldsToTheForce) {
  SeriesOptions options;
  options.trials = 30;
  options.jobs = 2;
  options.trial.slows_on_force = false;
  options.modalities = {Modality::kSpace, Modality::kSpaceAndHaptics};
  const auto outcomes = run_series(scene(), options);
  const auto change = [](std::span<const TrialOutcome> of) {
    return paired_difference(of, Modality::kSpace, Modality::kSpaceAndHaptics, &TrialOutcome::mean_approach_um_per_s);
  };
  EXPECT_LT(change(outcomes).upper, 0.0);
  EXPECT_LT(change(thirty()).mean, change(outcomes).mean);
}

TEST(Trial, ForceIsFeltInTheTwoHapticModalitiesAlone) {
  for (const TrialOutcome& outcome : thirty()) {
    const bool haptics =
        outcome.modality == Modality::kSpaceAndHaptics || outcome.modality == Modality::kSpaceAndFixture;
    // The link between hand and proxy alone stays far below what the cell gives.
    EXPECT_EQ(outcome.peak_hand_force_N > 0.2, haptics) << outcome.seed;
  }
}

TEST(Trial, SuccessIsWhatItsPartsSay) {
  int succeeded = 0;
  const TrialOptions options;
  for (const TrialOutcome& outcome : thirty()) {
    const bool all =
        outcome.punctured && outcome.deposited && outcome.removed && outcome.overshoot_um <= options.max_overshoot_um;
    EXPECT_EQ(outcome.success, all);
    EXPECT_TRUE(!outcome.deposited || outcome.deposit_error_um <= options.tolerance_um);
    EXPECT_LE(outcome.duration_s, options.time_limit_s + 1e-9);
    succeeded += outcome.success;
  }
  EXPECT_GT(succeeded, 60);
}

TEST(Trial, TimeRunsOut) {
  TrialOptions options;
  options.time_limit_s = 1.0;
  const TrialOutcome outcome = run_trial(scene(), options);
  EXPECT_FALSE(outcome.success);
  EXPECT_FALSE(outcome.punctured);
  EXPECT_NEAR(outcome.duration_s, 1.0, 1e-9);
  EXPECT_TRUE(std::isnan(outcome.deposit_error_um));
  EXPECT_TRUE(std::isnan(outcome.mean_approach_um_per_s));
}

TEST(Trial, NumbersOutOfRangeAreRefused) {
  TrialOptions options;
  options.tolerance_um = 0.0;
  EXPECT_THROW(run_trial(scene(), options), UsageError);
  options = {};
  options.force_scale_N_per_uN = 0.9;  // the device doesn't hold it
  options.modality = Modality::kSpaceAndHaptics;
  EXPECT_THROW(run_trial(scene(), options), UsageError);
  SeriesOptions none;
  none.trials = 0;
  EXPECT_THROW(run_series(scene(), none), UsageError);
  EXPECT_THROW(TrialScene(load_scenario("default")), UsageError);
}

TEST(TrialDraw, TheOperatorIsTheSameInEveryModality) {
  const DrawnOperator one = draw_operator(3, Modality::kFlatImage),
                      other = draw_operator(3, Modality::kSpaceAndFixture);
  EXPECT_EQ(one.arm.mass_kg, other.arm.mass_kg);
  EXPECT_EQ(one.options.tremor_rms_m, other.options.tremor_rms_m);
  EXPECT_EQ(one.insertion_speed_um_per_s, other.insertion_speed_um_per_s);
  EXPECT_NE(one.arm.mass_kg, draw_operator(4, Modality::kFlatImage).arm.mass_kg);
  EXPECT_NE(draw_placement(3).turn_deg, draw_placement(4).turn_deg);
}

}  // namespace
}  // namespace pellucida
