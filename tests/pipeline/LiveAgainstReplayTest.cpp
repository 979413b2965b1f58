#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "ReplayTools.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/pipeline/LiveRun.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "support/WaitUntil.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

/// Recorded by a live run, `speed_ratio` times as fast as the cell was pushed: frames are overtaken at every step.
void record_live(const Scenario& scenario, const fs::path& folder, double speed_ratio) {
  LiveRun run(std::make_unique<VirtualMicroscope>(scenario), {}, speed_ratio);
  run.start_recording(folder);
  run.start();
  ASSERT_TRUE(test::wait_until([&] { return run.status().finished; }));
  run.stop_recording();
  ASSERT_FALSE(run.status().fault) << *run.status().fault;
}

/// Frames overtaken, but not all that were in contact, on a slow machine either. Returns the session.
fs::path record_live_contact(const Scenario& scenario, const fs::path& parent) {
  for (double speed_ratio = 3.0; speed_ratio > 0.01; speed_ratio /= 2.0) {
    fs::path folder = parent / std::to_string(speed_ratio);
    record_live(scenario, folder, speed_ratio);
    const SessionReader session(folder);
    const auto& rows = session.measurements();
    if (testing::Test::HasFatalFailure() ||
        std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.contact_force_uN > 0.0; })) {
      return folder;
    }
  }
  ADD_FAILURE() << "no frame in contact was measured";
  return parent;
}

class LiveAgainstReplay : public testing::TestWithParam<const char*> {};

// Whatever the live run had time for: the replay gives the same bits, from the images and from the contours.
TEST_P(LiveAgainstReplay, HasTheSameNumbers) {
  const TemporaryFolder folder;
  const fs::path live = record_live_contact(quick_scenario(GetParam()), folder.path());
  ASSERT_FALSE(HasFailure());
  for (const auto& [name, rerun] : {std::pair{"tracking", Rerun::kTracking}, {"mechanics", Rerun::kMechanics}}) {
    const auto result = run_counterfactual(live, again(live, rerun), {same(live, folder / name)});
    const ChangeFigures& changes = result.variants.front().changes;
    EXPECT_EQ(changes.equal_row_count, changes.frame_count) << name;
    EXPECT_GT(changes.force_count, 0) << name;
    EXPECT_GT(changes.peak_force_uN, 0.0) << name;
    EXPECT_LT(changes.force_rms_uN, kNineDigits * std::max(1.0, changes.peak_force_uN)) << name;
    EXPECT_EQ(changes.largest_contour_um, 0.0) << name;
    EXPECT_EQ(changes.largest_node_force_uN, 0.0) << name;
    EXPECT_EQ(result.absent_count, 0);
    EXPECT_EQ(result.frames_before_recording, 0);
    expect_equal_rows(live, folder / name);
    EXPECT_EQ(check_session(folder / name, false).problem_count, 0U);
  }
}
INSTANTIATE_TEST_SUITE_P(Scenarios, LiveAgainstReplay, testing::Values("default", "puncture", "configuration-3"),
                         [](const auto& scenario) {
                           std::string name = scenario.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace pellucida
