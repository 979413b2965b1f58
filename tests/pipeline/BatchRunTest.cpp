#include "pellucida/pipeline/BatchRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/DamageCounter.h"
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

// Frames 4 to 6 were not decoded as they were recorded.
class DamagedSource final : public test::FlatSource {
 public:
  using test::FlatSource::FlatSource;
  std::optional<Frame> next() override {
    auto frame = test::FlatSource::next();
    if (frame) {
      const long index = frame->frame_index;
      frame->damage = damage_.add(index >= 4 && index <= 6, "bits are missing");
    }
    return frame;
  }

 private:
  DamageCounter damage_;
};

TEST(BatchRun, ADamagedFrameIsKeptNotMeasured) {
  for (const int job_count : {1, 2}) {
    DamagedSource source(10, 20.0);
    std::vector<Scene> scenes;
    const BatchResult result =
        run_batch(source, {.job_count = job_count}, [&](const Scene& scene) { scenes.push_back(scene); });
    ASSERT_EQ(scenes.size(), 10U);
    std::vector<std::string> told;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      EXPECT_EQ(scenes[i].measurement.state.has_value(), i < 4 || i > 6) << i;
      EXPECT_TRUE(scenes[i].frame) << i;
      for (const Event& event : scenes[i].events) {
        if (event.kind == event_kind::kDamaged) told.push_back(std::to_string(i) + ": " + event.detail);
      }
    }
    EXPECT_EQ(told, (std::vector<std::string>{"4: from frame 4 on not decoded as recorded (bits are missing)",
                                              "7: over, after 3 frames"}));
    EXPECT_EQ(damage_line(result),
              "damaged  3 frames were not decoded as recorded: kept, not measured; the first: 4 (bits are missing)\n");
  }
}

// At 53 um the embryo's dimple is deeper than its centre.
TEST(BatchRun, TheEmbryoHasItsSurfaceToTheEnd) {
  auto scenario = load_scenario("embryo");
  scenario.motion.approach_speed_um_per_s = 120.0;
  scenario.motion.indentation_speed_um_per_s = 40.0;
  scenario.motion.hold_s = 0.2;
  VirtualMicroscope microscope(scenario);
  double deepest_um = 0.0;
  double rest_um3 = 0.0;
  run_batch(microscope, {.pipeline = {.profile = "mouse-embryo"}}, [&](const Scene& scene) {
    if (!scene.observation->outer) return;
    ASSERT_TRUE(scene.surface) << scene.measurement.frame;
    const double volume_um3 = scene.measurement.volume_um3;
    if (rest_um3 == 0.0) rest_um3 = volume_um3;
    EXPECT_NEAR(volume_um3 / rest_um3, 1.0, 0.01) << scene.measurement.frame;
    deepest_um = std::max(deepest_um, scene.measurement.indentation_um);
  });
  EXPECT_GT(deepest_um, 50.0);
}

// The kind of cell can't be seen where sizes are alike: an embryo under the oocyte's profile reads too little. That it
// bears more than such oocytes do is all that shows.
TEST(BatchRun, ACellThatBearsMoreThanItsProfileIsAWarning) {
  auto scenario = load_scenario("embryo");
  scenario.motion.approach_speed_um_per_s = 120.0;
  scenario.motion.indentation_speed_um_per_s = 40.0;
  for (const auto& [profile, is_warned] : {std::pair{"mouse-oocyte", true}, std::pair{"mouse-embryo", false}}) {
    VirtualMicroscope microscope(scenario);
    const auto result = run_batch(microscope, {.pipeline = {.profile = profile}}, {});
    EXPECT_EQ(result.profile.name, profile);
    ASSERT_TRUE(result.peak);
    EXPECT_EQ(result.peak->remarks.warning.find("check that the profile") != std::string::npos, is_warned) << profile;
    EXPECT_TRUE(std::isfinite(result.peak->remarks.point_load_uN));
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
