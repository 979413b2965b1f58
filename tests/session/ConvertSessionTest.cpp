// Sessions of the layout before: readable, and written once more without a change but the precision of surfaces.
#include "pellucida/session/ConvertSession.h"

#include <vtkNew.h>

#include "SameData.h"
#include "SessionJson.h"
#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/GeneratedSession.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/vtk_files/SurfacePrecision.h"

namespace pellucida {
namespace {

using namespace test;

Frozen<vtkPolyData> two_points(double time_s) {
  auto block = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(time_s, 2.0, 3.0);
  points->InsertNextPoint(4.0, 5.0, 1.0 / 3.0);
  vtkNew<vtkCellArray> lines;
  const vtkIdType path[2] = {0, 1};
  for (int i = 0; i < 2; ++i) lines->InsertNextCell(2, path);
  block->SetPoints(points);
  block->SetLines(lines);
  return Frozen<vtkPolyData>(block.Get());
}

class ConvertSession : public testing::Test {
 protected:
  void SetUp() override {
    SessionInfo info = make_info();
    info.provenance_json = R"({"versions":{"Pellucida":"0.9"},"parameters":{"tracker":{"a":1}}})";
    info.plan_json = R"({"depth_stop_um":40})";
    SessionWriter writer(before(), info, {.frames = true, .layout = SessionLayout::kWide, .rewritten = {}});
    writer.event({0.0, event_kind::kStarted, ""});
    for (long frame = 0; frame < 5; ++frame) writer.write(frame == 3 ? make_empty_scene(frame) : make_scene(frame));
    writer.event({0.05, event_kind::kDropped, "2 frames, quoted \"so\""});
    writer.write_hand(two_points(0.0), 0.0);
    writer.write_hand(two_points(0.7), 0.7);
    writer.close();
    put(before() / "differences.csv", "frame\n0\n");
  }
  fs::path before() const { return folder_ / "before"; }
  fs::path after() const { return folder_ / "after"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(ConvertSession, TheLayoutBeforeIsReadAsItWasWritten) {
  const SessionReader session(before());
  EXPECT_EQ(read_session_json(before() / "session.json").options.layout, SessionLayout::kWide);
  expect_same(make_scene(2).surface.shallow_copy(), session.load(2).surface.shallow_copy());
  EXPECT_TRUE(check_session(before(), false).fine());
}

TEST_F(ConvertSession, NothingChangesButThePrecisionOfSurfaces) {
  const ConvertReport report = convert_session(before(), after());
  EXPECT_TRUE(report.notes.empty()) << testing::PrintToString(report.notes);
  EXPECT_LT(report.after.byte_count, report.before.byte_count);
  const SessionReport check = check_session(after(), false);
  EXPECT_TRUE(check.fine()) << testing::PrintToString(check.problems);
  EXPECT_EQ(rows_of(before() / "measurements.csv"), rows_of(after() / "measurements.csv"));
  EXPECT_EQ(rows_of(before() / "events.csv"), rows_of(after() / "events.csv"));
  EXPECT_EQ(text_of(after() / "differences.csv"), "frame\n0\n");

  const SessionReader old_session(before());
  const SessionReader new_session(after());
  ASSERT_EQ(new_session.steps().size(), 5U);
  for (std::size_t step = 0; step < 5; ++step) {
    const Scene one = old_session.load(step);
    const Scene other = new_session.load(step);
    ASSERT_EQ(static_cast<bool>(one.surface), static_cast<bool>(other.surface)) << step;
    expect_same_arrays(one.frame.shallow_copy()->GetPointData(), other.frame.shallow_copy()->GetPointData());
    EXPECT_EQ(one.frame.shallow_copy()->GetSpacing()[0], other.frame.shallow_copy()->GetSpacing()[0]);
    if (!one.surface) continue;
    expect_same(narrowed_surface(one.surface.shallow_copy()), other.surface.shallow_copy());
    expect_same(one.membranes.shallow_copy(), other.membranes.shallow_copy());
    expect_same(one.tools.shallow_copy(), other.tools.shallow_copy());
  }
  ASSERT_EQ(new_session.hand_block_count(), 2U);
  expect_same(old_session.load_hand(1).shallow_copy(), new_session.load_hand(1).shallow_copy());

  const SessionHead head = read_session_json(before() / "session.json");
  const SessionHead now = read_session_json(after() / "session.json");
  EXPECT_TRUE(now.complete);
  EXPECT_EQ(now.options.layout, SessionLayout::kCompact);
  EXPECT_EQ(now.created, head.created);
  EXPECT_EQ(now.info.provenance_json, head.info.provenance_json);
  EXPECT_EQ(now.info.plan_json, head.info.plan_json);
  EXPECT_EQ(now.info.seeds, head.info.seeds);
  EXPECT_EQ(now.counts.dropped_count, head.counts.dropped_count);
}

TEST_F(ConvertSession, WhatCantBeReadIsLeftOutAndNamed) {
  put(before() / "frames/frame_00000001.vti", "no image");
  fs::remove(before() / "haptics/haptics_00000000.vtp");
  const ConvertReport report = convert_session(before(), after());
  EXPECT_TRUE(mentions(report.notes, "frame_00000001.vti")) << testing::PrintToString(report.notes);
  const SessionReader session(after());
  EXPECT_FALSE(session.steps()[1].has(SessionPart::kFrame));
  EXPECT_TRUE(session.steps()[1].has(SessionPart::kSurface));
  EXPECT_EQ(session.hand_block_count(), 1U);
  EXPECT_TRUE(check_session(after(), false).fine());
}

// A recording that was cut off stays one, and one that may still go on is left alone.
TEST_F(ConvertSession, ARecordingThatWasCutOffStaysSo) {
  const fs::path cut = before().parent_path() / "cut";
  { SessionWriter(cut, make_info()).write(make_scene(0)); }
  EXPECT_THROW(convert_session(cut, after()), InputError);
  EXPECT_FALSE(fs::exists(after()));
  EXPECT_TRUE(check_session(cut, true).repaired);
  convert_session(cut, after());
  const SessionHead head = read_session_json(after() / "session.json");
  EXPECT_FALSE(head.complete);
  EXPECT_TRUE(head.recovered);
  EXPECT_TRUE(check_session(after(), false).fine());
}

TEST_F(ConvertSession, NeverWritesOverASession) {
  EXPECT_THROW(convert_session(before(), before()), UsageError);
  EXPECT_THROW(convert_session(after(), before()), InputError);
}

// What `bench session` opens has a row, a name and a checksum for everything, and whole steps where it looks.
TEST(GenerateSession, IsAnIndexOfItsLengthWithWholeStepsInIt) {
  const TemporaryFolder folder;
  for (const SessionLayout layout : {SessionLayout::kWide, SessionLayout::kCompact}) {
    const fs::path session = folder / (layout == SessionLayout::kWide ? "wide" : "compact");
    generate_session(session, make_info(), {make_scene(0), make_scene(1)},
                     {.step_count = 40, .frame_rate_hz = 10.0, .whole_every = 10, .layout = layout});
    const SessionReader reader(session);
    ASSERT_EQ(reader.steps().size(), 40U);
    EXPECT_EQ(reader.skipped_row_count(), 0U);
    EXPECT_DOUBLE_EQ(reader.steps()[39].time_s, 3.9);
    for (const SessionStep& step : reader.steps()) {
      for (const bool present : step.present) EXPECT_TRUE(present) << step.frame_index;
    }
    const Scene scene = reader.load(30);
    EXPECT_EQ(scene.surface.shallow_copy()->GetFieldData()->GetNumberOfArrays(), 3);
    EXPECT_EQ(scene.measurement.frame, 30);
  }
  EXPECT_THROW(generate_session(folder / "none", make_info(), {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace pellucida
