#include "Recorder.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <future>
#include <thread>

#include "Chain.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionReader.h"
#include "pipeline/FlatSource.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

// A disk that stalls until it may go on.
class StalledDisk {
 public:
  std::function<void()> wait() const {
    return [moved = moved_] { moved.wait(); };
  }
  void go_on() { go_on_.set_value(); }

 private:
  std::promise<void> go_on_;
  std::shared_future<void> moved_ = go_on_.get_future().share();
};

class RecorderTest : public testing::Test {
 protected:
  std::vector<Scene> scenes(long count) {
    test::FlatSource source(count, 30.0);
    std::vector<Scene> all;
    while (const auto frame = source.next()) all.push_back(scene_of(*frame, 0.0, 0));
    return all;
  }
  static Scene measured(Scene scene) {
    scene.measurement.state = CellState::kFree;
    return scene;
  }
  static std::vector<Event> of_kind(const SessionReader& session, const std::string& kind) {
    std::vector<Event> found;
    std::copy_if(session.events().begin(), session.events().end(), std::back_inserter(found),
                 [&](const Event& event) { return event.kind == kind; });
    return found;
  }
  fs::path session() const { return folder_ / "s"; }
  static SessionInfo info() {
    SessionInfo info;
    info.source = test::FlatSource(1, 30.0).info();
    return info;
  }

  SteadyClock clock_;

 private:
  TemporaryFolder folder_;
};

// The window and the camera go on while the disk has stalled; nothing is lost.
TEST_F(RecorderTest, NobodyWaitsForTheDiskAndNothingIsLost) {
  StalledDisk disk;
  Recorder recorder(session(), info(), clock_, recording_memory_bytes(), disk.wait());
  const auto frames = scenes(600);
  auto given = std::async(std::launch::async, [&] {
    for (const Scene& frame : frames) {
      recorder.announce(frame);
      recorder.settle(measured(frame));
    }
    recorder.plan(R"({"depth_stop_um": 40})");
    recorder.event({1.0, event_kind::kNote, "said while the disk has stalled"});
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(1.0, 2.0, 3.0);
    vtkNew<vtkPolyData> block;
    block->SetPoints(points);
    return recorder.hand(Frozen<vtkPolyData>(block.Get()), 0.0);
  });
  const bool returned = given.wait_for(std::chrono::seconds(30)) == std::future_status::ready;
  EXPECT_TRUE(returned) << "somebody waits for the disk";
  disk.go_on();
  EXPECT_TRUE(given.get());
  recorder.close();

  EXPECT_EQ(recorder.written_count(), 600U);
  EXPECT_EQ(recorder.dropped_count(), 0U);
  EXPECT_EQ(check_session(session(), false).problem_count, 0U);
  const SessionReader written(session());
  ASSERT_EQ(written.steps().size(), 600U);
  for (const SessionStep& step : written.steps()) EXPECT_TRUE(step.has(SessionPart::kFrame)) << step.frame_index;
  EXPECT_NE(written.info().plan_json.find("40"), std::string::npos);
  EXPECT_EQ(of_kind(written, "note").size(), 1U);
  EXPECT_TRUE(of_kind(written, "dropped").empty());
}

// Where memory ends, images go: rows, events and their order stay, and the loss is named and counted.
TEST_F(RecorderTest, WithoutMemoryImagesGoAndRowsStay) {
  const auto frames = scenes(300);
  StalledDisk disk;
  Recorder recorder(session(), info(), clock_, 100'000, disk.wait());  // some twenty of these images
  for (const Scene& frame : frames) {
    recorder.announce(frame);
    recorder.settle(measured(frame));
  }
  disk.go_on();
  recorder.close();

  EXPECT_EQ(recorder.written_count(), 300U);
  EXPECT_GT(recorder.dropped_count(), 100U);
  EXPECT_LT(recorder.dropped_count(), 300U);
  EXPECT_EQ(check_session(session(), false).problem_count, 0U);
  const SessionReader written(session());
  ASSERT_EQ(written.steps().size(), 300U);
  const auto imageless = std::count_if(written.steps().begin(), written.steps().end(),
                                       [](const auto& step) { return !step.has(SessionPart::kFrame); });
  EXPECT_EQ(static_cast<std::uint64_t>(imageless), recorder.dropped_count());
  EXPECT_EQ(written.stated_counts().dropped_count, recorder.dropped_count());
  const auto dropped = of_kind(written, "dropped");
  ASSERT_EQ(dropped.size(), 1U) << "one row for a stretch, not one for a frame";
  EXPECT_TRUE(dropped[0].detail.starts_with(std::to_string(imageless) + " frames")) << dropped[0].detail;
  EXPECT_EQ(written.measurements().back().state, CellState::kFree);
}

// A sink slower than the camera: surfaces go first, then images; rows, events and the hand stay, each loss is counted
// everywhere, and the frames in front of the queue's end are whole.
TEST_F(RecorderTest, ASlowSinkCostsSurfacesFirstThenImages) {
  const auto measured_with_surface = [](Scene scene) {
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 300; ++i) points->InsertNextPoint(i, 0.5 * i, 1.0);
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    scene.surface = Frozen<vtkPolyData>(surface.Get());
    return measured(std::move(scene));
  };
  const auto frames = scenes(200);
  StalledDisk disk;
  Recorder recorder(session(), info(), clock_, 1'000'000, disk.wait());
  bool hand_taken = true;
  for (const Scene& frame : frames) {
    recorder.announce(frame);
    recorder.settle(measured_with_surface(frame));
    if (frame.measurement.frame % 10 == 0) {
      vtkNew<vtkPoints> points;
      points->InsertNextPoint(1.0, 2.0, 3.0);
      vtkNew<vtkPolyData> block;
      block->SetPoints(points);
      hand_taken = recorder.hand(Frozen<vtkPolyData>(block.Get()), frame.measurement.time_s) && hand_taken;
      recorder.event({frame.measurement.time_s, event_kind::kNote, "said meanwhile"});
    }
    EXPECT_LE(recorder.waiting_bytes(), 1'000'000U + 200U * sizeof(Scene)) << "the queue has a bound";
  }
  disk.go_on();
  recorder.close();

  EXPECT_TRUE(hand_taken);
  EXPECT_EQ(recorder.written_count(), 200U);
  EXPECT_GT(recorder.dropped_count(), 50U);
  EXPECT_GT(recorder.thinned_count(), recorder.dropped_count() + 5);
  const SessionReport report = check_session(session(), false);
  EXPECT_EQ(report.problem_count, 0U) << testing::PrintToString(report.problems);
  EXPECT_EQ(report.counts.thinned_count, recorder.thinned_count());
  EXPECT_EQ(report.counts.dropped_count, recorder.dropped_count());
  const SessionReader written(session());
  EXPECT_EQ(written.stated_counts().thinned_count, recorder.thinned_count());
  ASSERT_EQ(written.steps().size(), 200U);
  EXPECT_EQ(written.hand_block_count(), 20U);
  EXPECT_EQ(of_kind(written, "note").size(), 20U);
  long first_without_surface = 200, first_without_image = 200;
  for (const SessionStep& step : written.steps()) {
    if (!step.has(SessionPart::kSurface)) first_without_surface = std::min(first_without_surface, step.frame_index);
    if (!step.has(SessionPart::kFrame)) first_without_image = std::min(first_without_image, step.frame_index);
    EXPECT_FALSE(step.has(SessionPart::kSurface) && !step.has(SessionPart::kFrame)) << step.frame_index;
  }
  EXPECT_LT(first_without_surface, first_without_image);
  const auto thinned = of_kind(written, "thinned");
  ASSERT_EQ(thinned.size(), 1U);
  EXPECT_TRUE(thinned[0].detail.starts_with(std::to_string(recorder.thinned_count()) + " frames")) << thinned[0].detail;
  for (const Measurement& row : written.measurements()) EXPECT_EQ(row.state, CellState::kFree);
}

// The advice names what was slow: here the measuring, which settles nothing.
TEST_F(RecorderTest, TheReasonIsTheQueueThatWasFull) {
  const auto frames = scenes(300);
  Recorder recorder(session(), info(), clock_, 100'000);
  for (const Scene& frame : frames) recorder.announce(frame);
  recorder.close();
  EXPECT_GT(recorder.dropped_count(), 100U);
  const auto dropped = of_kind(SessionReader(session()), "dropped");
  ASSERT_EQ(dropped.size(), 1U);
  EXPECT_NE(dropped[0].detail.find("measuring fell too far behind"), std::string::npos) << dropped[0].detail;
}

// Kept, but not measured: no state, no numbers, the image, one event for all of them.
TEST_F(RecorderTest, AFrameThatWasNotMeasuredSaysSo) {
  Recorder recorder(session(), info(), clock_);
  for (const Scene& frame : scenes(60)) {
    recorder.announce(frame);
    const bool overtaken = frame.measurement.frame % 2 == 1;
    recorder.settle(overtaken ? frame : measured(frame));
  }
  recorder.close();
  const SessionReader written(session());
  ASSERT_EQ(written.measurements().size(), 60U);
  for (const Measurement& row : written.measurements()) EXPECT_EQ(row.state.has_value(), row.frame % 2 == 0);
  EXPECT_EQ(written.stated_counts().unmeasured_count, 30U);
  EXPECT_EQ(written.stated_counts().dropped_count, 0U);
  const auto unmeasured = of_kind(written, "unmeasured");
  ASSERT_EQ(unmeasured.size(), 1U);
  EXPECT_TRUE(unmeasured[0].detail.starts_with("30 frames (within 1 to 59)")) << unmeasured[0].detail;
}

// A camera that loses every other frame: one row of events for all of them.
TEST_F(RecorderTest, GapsOfTheSourceAreOneEventForAStretch) {
  Recorder recorder(session(), info(), clock_);
  for (Scene& frame : scenes(60)) {
    frame.events.clear();
    if (frame.measurement.frame % 2 == 1) {
      frame.events.push_back({frame.measurement.time_s, event_kind::kGap, "2 frames missing from the source"});
    }
    frame.events.push_back({frame.measurement.time_s, event_kind::kNote, "stays"});
    recorder.announce(frame);
    recorder.settle(measured(frame));
  }
  recorder.close();
  const SessionReader written(session());
  const auto gaps = of_kind(written, "gap");
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_EQ(gaps[0].detail, "60 frames missing from the source, the first before frame 1, the last before frame 59");
  EXPECT_EQ(of_kind(written, "note").size(), 60U);
}

TEST_F(RecorderTest, AFaultIsReportedAndWhatItCostsIsCounted) {
  Recorder recorder(session(), info(), clock_);
  fs::remove_all(session() / "frames");  // the disk refuses images from here on
  for (const Scene& frame : scenes(20)) {
    recorder.announce(frame);
    recorder.settle(measured(frame));
  }
  EXPECT_THROW(recorder.close(), OutputError);
  EXPECT_TRUE(recorder.fault());
  EXPECT_FALSE(recorder.event({0.0, event_kind::kNote, "too late"}));
  // The frame that met the fault is neither written nor left behind.
  EXPECT_GE(recorder.written_count() + recorder.dropped_count(), 19U);
}

}  // namespace
}  // namespace pellucida
