// The force of the shipped scenarios through tracker and observer, against the virtual microscope's truth, which comes
// from finite elements: the share of error and the honesty of its two 95 % intervals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "integration/ForceRun.h"

namespace pellucida {
namespace {

TEST(ForceScenarios, ForceIsCloseAndItsIntervalHonestOverAllShippedScenarios) {
  constexpr double kDeep_um = 5.0;  // nearer to the touch the force is small against any error of its place
  std::vector<double> rms_percent, half_width_percent;
  int contact_count = 0, covered_count = 0;
  double covered_of_kind = 0.0;
  for (const std::string& name : scenario_names()) {
    const Scenario scenario = load_scenario(name);
    const test::ForceRun run = test::run_force(scenario, test::profile_of(scenario));
    ASSERT_GT(run.contact_count(), 50) << name;
    const double rms = run.rms_percent_of_peak();
    EXPECT_LE(rms, 5.0) << name;
    rms_percent.push_back(rms);
    contact_count += run.contact_count();
    covered_count += run.covered_count();
    for (const test::ForceFrame& f : run.frames) {
      if (f.is_measured && f.true_state == CellState::kContact && f.true_depth_um > kDeep_um)
        half_width_percent.push_back(50.0 * (f.picture_upper_uN - f.picture_lower_uN) / f.force_uN);
    }
    covered_of_kind += run.covered_share_of_kind() * run.contact_count();
    std::printf(
        "%-26s RMS %5.2f %% of peak, %d of %d contact frames inside the picture's 95 %% interval; of cells of "
        "this kind %.1f %% inside the whole\n",
        name.c_str(), rms, run.covered_count(), run.contact_count(), 100.0 * run.covered_share_of_kind());
  }
  std::sort(rms_percent.begin(), rms_percent.end());
  EXPECT_LE(rms_percent[rms_percent.size() / 2], 1.8);
  const double coverage = static_cast<double>(covered_count) / contact_count;
  EXPECT_GE(coverage, 0.94);
  // An interval that holds everything must still say something.
  std::sort(half_width_percent.begin(), half_width_percent.end());
  const double usual_percent = half_width_percent[half_width_percent.size() / 2];
  std::printf("half the picture's interval: %.1f %% of the force in the median\n", usual_percent);
  EXPECT_LE(usual_percent, 35.0);
  // Cells whose stiffness differs as that of single cells of a kind does: what the whole interval is for.
  covered_of_kind /= contact_count;
  EXPECT_GE(covered_of_kind, 0.93);
  EXPECT_LE(covered_of_kind, 0.98);
}

}  // namespace
}  // namespace pellucida
