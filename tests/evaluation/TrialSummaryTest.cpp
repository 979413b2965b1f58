#include "pellucida/evaluation/TrialSummary.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "pellucida/core/Table.h"
#include "pellucida/haptics/LimitEvent.h"

namespace pellucida {
namespace {

std::vector<TrialOutcome> three_outcomes() {
  std::vector<TrialOutcome> outcomes(3);
  outcomes[0].modality = outcomes[1].modality = Modality::kSpace;
  outcomes[2].modality = Modality::kSpaceAndHaptics;
  for (int k = 0; k < 3; ++k) {
    outcomes[k].seed = k < 2 ? 5U + static_cast<unsigned>(k) : 6U;
    outcomes[k].peak_approach_um_per_s = 50.0 + 10.0 * k;
    outcomes[k].success = k > 0;
  }
  outcomes[0].deposit_error_um = std::numeric_limits<double>::quiet_NaN();
  outcomes[2].limits = limit_bit(LimitKind::kPuncture) | limit_bit(LimitKind::kDepth);
  return outcomes;
}

TEST(TrialSummary, CountsByModality) {
  const auto summaries = summarize(three_outcomes());
  ASSERT_EQ(summaries.size(), 2U);
  EXPECT_EQ(summaries[0].count, 2);
  EXPECT_EQ(summaries[0].success_count, 1);
  EXPECT_EQ(summaries[1].count, 1);
  EXPECT_EQ(summaries[1].modality, Modality::kSpaceAndHaptics);
}

TEST(TrialSummary, PairsBySeed) {
  const Estimate change = paired_difference(three_outcomes(), Modality::kSpace, Modality::kSpaceAndHaptics,
                                            &TrialOutcome::peak_approach_um_per_s);
  EXPECT_EQ(change.count, 1);
  EXPECT_DOUBLE_EQ(change.mean, 10.0);
}

TEST(TrialSummary, EveryOutputSaysThatTheOperatorIsSimulated) {
  const auto outcomes = three_outcomes();
  const auto summaries = summarize(outcomes);
  std::ostringstream trials, summary;
  write_trials_csv(trials, outcomes);
  write_summary_csv(summary, summaries);
  for (const std::string& text : {trials.str(), summary.str()}) {
    std::istringstream file(text);
    std::string line;
    std::getline(file, line);
    const auto columns = split_csv(line).size();
    EXPECT_EQ(line.rfind("operator,", 0), 0U);
    int rows = 0;
    for (; std::getline(file, line); ++rows) {
      EXPECT_EQ(split_csv(line).size(), columns) << line;
      EXPECT_EQ(line.rfind("simulated,", 0), 0U) << line;
    }
    EXPECT_GE(rows, 3);
  }
  EXPECT_EQ(table_text(summaries).rfind("SIMULATED operator", 0), 0U);
  EXPECT_NE(effects_text(outcomes).find("simulated operator"), std::string::npos);
  EXPECT_NE(trials.str().find("depth; puncture"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
