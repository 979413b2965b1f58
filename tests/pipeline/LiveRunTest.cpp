#include "pellucida/pipeline/LiveRun.h"

#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

#include "pellucida/core/Error.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pipeline/FlatSource.h"
#include "support/WaitUntil.h"

namespace pellucida {
namespace {

using test::wait_until;

namespace fs = std::filesystem;

fs::path fresh(const std::string& name) {
  const auto folder = fs::path(testing::TempDir()) / ("pellucida_live_" + name);
  fs::remove_all(folder);
  return folder;
}

TEST(LiveRun, EveryFrameIsMeasuredOrCountedAsSkipped) {
  LiveRun run(std::make_unique<test::FlatSource>(60, 200.0), {});
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().finished; }));
  const LiveStatus status = run.status();
  EXPECT_EQ(status.frame_count, 60U);
  EXPECT_EQ(status.measured_count + status.skipped_count, 60U);
  EXPECT_EQ(status.gap_count, 1U);
  EXPECT_EQ(run.measurements_since(0).size(), status.measured_count);
  EXPECT_FALSE(status.fault);
  ASSERT_TRUE(run.scenes()->peek());
  EXPECT_EQ(run.scenes()->peek()->measurement.frame, 59);  // the newest always gets through
}

// Frames come faster than they can be measured: all of them are in the recording all the same, in order, each once.
TEST(LiveRun, TheRecordingHoldsEveryFrame) {
  const auto folder = fresh("record");
  LiveRun run(std::make_unique<test::FlatSource>(100, 2000.0), {});
  run.start_recording(folder);
  EXPECT_THROW(run.start_recording(fresh("other")), UsageError);
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().finished; }));
  run.note("the dish is empty");
  run.stop_recording();
  EXPECT_FALSE(run.status().recording);
  EXPECT_EQ(run.status().recorded_count, 100U);
  EXPECT_EQ(run.status().recorder_dropped_count, 0U);

  EXPECT_EQ(check_session(folder, false).problem_count, 0U);
  const SessionReader session(folder);
  EXPECT_TRUE(session.complete());
  long last = -1;
  for (const auto& step : session.steps()) {
    EXPECT_GT(step.frame_index, last);
    EXPECT_TRUE(step.has(SessionPart::kFrame));
    last = step.frame_index;
  }
  EXPECT_EQ(session.steps().size(), run.status().recorded_count);
  // Who was overtaken has no state: the tracker says `no_cell` of this empty dish, and never `lost`.
  for (const Measurement& row : session.measurements()) EXPECT_NE(row.state, CellState::kLost);
  EXPECT_TRUE(std::is_sorted(session.events().begin(), session.events().end(),
                             [](const Event& a, const Event& b) { return a.time_s < b.time_s; }));
  bool noted = false;
  for (const auto& event : session.events()) noted |= event.kind == "note" && event.detail == "the dish is empty";
  EXPECT_TRUE(noted);
}

TEST(LiveRun, TheRecordingHoldsTheHandThePlanAndItsEvents) {
  const auto folder = fresh("hand");
  LiveRun run(std::make_unique<test::FlatSource>(5, 200.0), {});
  run.set_plan(R"({"depth_stop_um": 40})");
  run.start_recording(folder);
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().finished; }));
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 3.0);
  vtkNew<vtkPolyData> block;
  block->SetPoints(points);
  EXPECT_TRUE(run.record_hand(Frozen<vtkPolyData>(block.Get()), 0.0));
  EXPECT_TRUE(run.record_hand(Frozen<vtkPolyData>(block.Get()), 1.0));
  run.add_event({0.5, "limit", "depth: 40.1 um, at most 40"});
  run.set_plan(R"({"depth_stop_um": 42})");
  run.stop_recording();
  EXPECT_TRUE(run.record_hand(Frozen<vtkPolyData>(block.Get()), 2.0));  // no recording: no waiting

  EXPECT_EQ(check_session(folder, false).problem_count, 0U);
  const SessionReader session(folder);
  EXPECT_EQ(session.hand_block_count(), 2U);
  EXPECT_NE(session.info().plan_json.find("42"), std::string::npos);
  EXPECT_TRUE(std::any_of(session.events().begin(), session.events().end(),
                          [](const Event& event) { return event.kind == "limit" && event.time_s == 0.5; }));
}

// What was said before the recording began is in it all the same, with its time.
TEST(LiveRun, ANoteWhileNothingRecordsGoesIntoTheNextRecording) {
  const auto folder = fresh("note");
  LiveRun run(std::make_unique<test::FlatSource>(5, 200.0), {});
  EXPECT_FALSE(run.note("a new dish"));
  EXPECT_EQ(run.status().waiting_note_count, 1U);
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().finished; }));
  run.start_recording(folder);
  EXPECT_EQ(run.status().waiting_note_count, 0U);
  EXPECT_TRUE(run.note("said while recording"));
  run.stop_recording();
  const SessionReader session(folder);
  ASSERT_EQ(session.events().size(), 4U);
  EXPECT_EQ(session.events()[0].kind, "note");
  EXPECT_EQ(session.events()[0].detail, "a new dish");
  EXPECT_EQ(session.events()[0].time_s, 0.0);
  EXPECT_EQ(session.events()[1].kind, "started");
}

// A camera goes on during a pause: what it shows then is left out on purpose, not lost.
TEST(LiveRun, APauseWhileRecordingIsReportedAndIsNoLossOfTheSource) {
  const auto folder = fresh("pause");
  LiveRun run(std::make_unique<test::WallClockSource>(100.0), {});
  run.start_recording(folder);
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().frame_count >= 5; }));
  const auto gaps_before = run.status().gap_count;
  run.set_paused(true);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // the frame on its way comes through
  const auto paused_at = run.status().frame_count;
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_LE(run.status().frame_count, paused_at + 1);
  run.set_paused(false);
  ASSERT_TRUE(wait_until([&] { return run.status().frame_count >= paused_at + 5; }));
  run.stop();
  const SessionReader session(folder);
  const auto count = [&](const char* kind) {
    return std::count_if(session.events().begin(), session.events().end(),
                         [&](const Event& event) { return event.kind == kind; });
  };
  EXPECT_EQ(count("paused"), 1);
  ASSERT_EQ(count("resumed"), 1);
  const auto resumed = std::find_if(session.events().begin(), session.events().end(),
                                    [](const Event& event) { return event.kind == "resumed"; });
  EXPECT_GE(std::atol(resumed->detail.c_str()), 20) << resumed->detail;
  // A busy machine may lose frames of its own, but not those of the pause.
  EXPECT_LT(run.status().gap_count - gaps_before, 20U);
}

/// A block handed over whole, as `Frozen` asks: once this has returned, nobody else holds a part of it.
Frozen<vtkPolyData> hand_block() {
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 3.0);
  vtkNew<vtkPolyData> block;
  block->SetPoints(points);
  return Frozen<vtkPolyData>(block.Get());
}

// The window, the hand's recorder and others at once (the header says which calls may come from anywhere).
TEST(LiveRun, AnyThreadMayCallWhatMayComeFromAnyThread) {
  LiveRun run(std::make_unique<test::FlatSource>(400, 400.0), {});
  run.start();
  std::atomic<long> started{0};
  {
    std::vector<std::jthread> threads;
    for (int part = 0; part < 2; ++part) {
      threads.emplace_back([&, part] {
        for (int i = 0; i < 5; ++i) {
          try {
            run.start_recording(fresh("threads" + std::to_string(part) + std::to_string(i)));
            ++started;
          } catch (const UsageError&) {
            // The other one records.
          }
          run.stop_recording();
        }
      });
    }
    threads.emplace_back([&] {
      for (int i = 0; i < 200; ++i) {
        run.record_hand(hand_block(), 0.01 * i);
        run.add_event({0.01 * i, "limit", "depth"});
        run.set_plan(R"({"depth_stop_um": 40})");
      }
    });
    threads.emplace_back([&] {
      for (int i = 0; i < 200; ++i) {
        run.set_paused(i % 2 == 0);
        run.note("note");
        static_cast<void>(run.status());
        static_cast<void>(run.measurements_since(0).size() + run.events_since(0).size());
        if (i % 50 == 0) run.restart();
      }
    });
  }
  run.set_paused(false);
  run.stop();
  EXPECT_GE(started, 1);
  EXPECT_FALSE(run.status().fault) << *run.status().fault;
  const auto events = run.events_since(0);
  EXPECT_EQ(std::count_if(events.begin(), events.end(), [](const Event& event) { return event.kind == "note"; }), 200);
  EXPECT_EQ(std::count_if(events.begin(), events.end(), [](const Event& event) { return event.kind == "limit"; }), 200);
}

TEST(LiveRun, EachMeasuredFrameIsHandedToTheHand) {
  LiveRun run(open_virtual("default"), {});
  std::atomic<long> count{0};
  std::atomic<long> valid_count{0};
  std::atomic<double> newest_s{-1.0};
  run.set_contact_sink([&](const ContactModel& contact) {
    ++count;
    valid_count += contact.valid ? 1 : 0;
    newest_s = contact.time_s;
  });
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().measured_count >= 3; }));
  run.stop();
  EXPECT_EQ(static_cast<std::uint64_t>(count), run.status().measured_count);
  EXPECT_GT(valid_count, 0);
  EXPECT_GT(newest_s, 0.0);
  EXPECT_LE(newest_s, run.clock().now_s());
}

TEST(LiveRun, ABrokenSourceIsAFaultAndWhatCameBeforeStays) {
  LiveRun run(std::make_unique<test::FlatSource>(60, 200.0, 20), {});
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().fault.has_value(); }));
  EXPECT_NE(run.status().fault->find("broken after frame 19"), std::string::npos);
  EXPECT_TRUE(wait_until([&] { return run.status().finished; }));
  EXPECT_EQ(run.status().frame_count, 20U);
}

TEST(LiveRun, PauseHoldsAndRestartBeginsAnew) {
  LiveRun run(std::make_unique<test::FlatSource>(30, 300.0), {});
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().finished; }));
  EXPECT_TRUE(run.restart());
  ASSERT_TRUE(wait_until([&] { return run.status().frame_count == 60U && run.status().finished; }));
  const auto newest = run.scenes()->peek();
  EXPECT_EQ(newest->measurement.frame, 59);  // numbers go on rising
  EXPECT_EQ(newest->run_index, 1);

  run.set_paused(true);
  EXPECT_TRUE(run.restart());
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(run.status().frame_count, 60U);
  run.set_paused(false);
  EXPECT_TRUE(wait_until([&] { return run.status().frame_count == 90U; }));
}

// A scenario shown twice is the same experiment twice: nothing of the first run's indented cell stays in any step's
// memory.
TEST(LiveRun, ARestartForgetsTheCell) {
  auto scenario = load_scenario("default");
  scenario.image.duration_s = 2.0;
  scenario.image.frame_rate_hz = 10.0;
  LiveRun run(std::make_unique<VirtualMicroscope>(scenario), {});
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().finished; }));
  ASSERT_EQ(run.measurements_since(0).back().state, CellState::kContact);
  ASSERT_TRUE(run.restart());
  ASSERT_TRUE(wait_until([&] { return run.status().frame_count == 40U && run.status().finished; }));
  const auto rows = run.measurements_since(0);
  const auto first_again = std::find_if(rows.begin(), rows.end(), [](const Measurement& m) { return m.frame >= 20; });
  ASSERT_NE(first_again, rows.end());
  EXPECT_EQ(first_again->state, CellState::kFree);
  EXPECT_DOUBLE_EQ(first_again->contact_force_uN, 0.0);
  for (const Event& event : run.events_since(0)) EXPECT_NE(event.kind, "puncture");
}

// However few frames a slow machine has time for, the first is always measured, and each row has its age.
TEST(LiveRun, RowsCarryTheAgeOfTheirFrame) {
  auto scenario = load_scenario("default");
  scenario.image.duration_s = 1.0;
  scenario.image.frame_rate_hz = 10.0;
  LiveRun run(std::make_unique<VirtualMicroscope>(scenario), {});
  run.start();
  ASSERT_TRUE(wait_until([&] { return run.status().finished; }));
  const auto rows = run.measurements_since(0);
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front().state, CellState::kFree);
  for (const auto& row : rows) EXPECT_GE(row.frame_age_ms, 0.0);
}

}  // namespace
}  // namespace pellucida
