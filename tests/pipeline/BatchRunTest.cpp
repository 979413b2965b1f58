#include "pellucida/pipeline/BatchRun.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/core/Error.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pipeline/FlatSource.h"

namespace pellucida {
namespace {

TEST(BatchRun, MeasuresEveryFrameInOrder) {
  test::FlatSource source(12, 30.0);
  std::vector<long> seen;
  const auto result = run_batch(source, {}, [&](const Scene& scene) { seen.push_back(scene.measurement.frame); });
  ASSERT_EQ(result.rows.size(), 12U);
  for (long i = 0; i < 12; ++i) EXPECT_EQ(seen[static_cast<std::size_t>(i)], i);
  EXPECT_EQ(result.state_count.at(CellState::kNoCell), 12);
  EXPECT_TRUE(std::isnan(result.rows[0].contact_force_uN));
  EXPECT_EQ(result.step_us.at("tracking").count(), 12U);
  EXPECT_FALSE(result.input_fault);
}

TEST(BatchRun, ABrokenInputLeavesWhatCameBefore) {
  for (const int jobs : {1, 4}) {
    test::FlatSource source(12, 30.0, 7);
    const auto result = run_batch(source, {.job_count = jobs}, {});
    EXPECT_EQ(result.rows.size(), 7U);
    ASSERT_TRUE(result.input_fault);
    EXPECT_THROW(std::rethrow_exception(result.input_fault), InputError);
  }
}

TEST(BatchRun, AFullDiskEndsTheRun) {
  for (const int jobs : {1, 4}) {
    test::FlatSource source(1000, 30.0);
    const auto full = [](const Scene& scene) {
      if (scene.measurement.frame == 5) throw OutputError("no space");
    };
    EXPECT_THROW(run_batch(source, {.job_count = jobs}, full), OutputError);
  }
}

TEST(BatchRun, AnUnknownProfileIsRefusedBeforeTheFirstFrame) {
  test::FlatSource source(12, 30.0);
  EXPECT_THROW(run_batch(source, {.pipeline = {.profile = "frog"}}, {}), UsageError);
  EXPECT_EQ(source.next()->frame_index, 0);
}

// The numbers don't depend on how many threads measure.
TEST(BatchRun, JobsDoNotChangeTheNumbers) {
  std::vector<std::vector<Measurement>> rows;
  for (const int jobs : {1, 4}) {
    auto scenario = load_scenario("default");
    scenario.image.duration_s = 1.2;
    VirtualMicroscope microscope(scenario);
    rows.push_back(run_batch(microscope, {.job_count = jobs}, {}).rows);
  }
  ASSERT_EQ(rows[0].size(), rows[1].size());
  for (std::size_t i = 0; i < rows[0].size(); ++i) {
    Measurement a = rows[0][i];
    Measurement b = rows[1][i];
    a.frame_age_ms = b.frame_age_ms = 0.0;
    EXPECT_EQ(to_csv(a), to_csv(b));
  }
}

}  // namespace
}  // namespace pellucida
