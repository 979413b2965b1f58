// What the window in Review mode says and where it goes, without a window.
#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>

#include <cmath>

#include "pellucida/core/Error.h"
#include "presenters/NodeHistory.h"
#include "presenters/RecordedSession.h"
#include "presenters/ReviewEvents.h"
#include "presenters/SessionCurves.h"
#include "presenters/StepLoader.h"
#include "presenters/SurfaceNode.h"
#include "presenters/TimelinePresenter.h"
#include "session/TestSession.h"
#include "support/WaitUntil.h"

namespace pellucida {
namespace {

// Ten frames a second: free, a touch with a force, a hole in time, unmeasured frames, a second touch, free.
RecordedSession two_touches() {
  RecordedSession session;
  const auto add = [&](double time_s, std::optional<CellState> state, double force_uN, double indentation_um) {
    Measurement row;
    row.frame = static_cast<long>(session.rows.size());
    row.time_s = time_s;
    row.state = state;
    row.confidence = state ? 0.9 : Measurement::kNotMeasured;
    row.contact_force_uN = force_uN;
    row.contact_force_lower_uN = 0.8 * force_uN;
    row.contact_force_upper_uN = 1.2 * force_uN;
    row.contact_force_picture_lower_uN = 0.95 * force_uN;
    row.contact_force_picture_upper_uN = 1.05 * force_uN;
    row.indentation_um = indentation_um;
    session.rows.push_back(row);
    session.times_s.push_back(time_s);
  };
  const double none = Measurement::kNotMeasured;
  for (int i = 0; i < 5; ++i) add(0.1 * i, CellState::kFree, none, 0.0);
  for (int i = 5; i < 10; ++i) add(0.1 * i, CellState::kContact, 0.1 * i, i);
  for (int i = 10; i < 12; ++i) add(0.1 * i, CellState::kFree, none, 0.0);
  for (int i = 0; i < 3; ++i) add(5.0 + 0.1 * i, std::nullopt, none, none);
  for (int i = 3; i < 8; ++i) add(5.0 + 0.1 * i, CellState::kContact, i == 5 ? none : 0.2 * i, i);
  for (int i = 8; i < 10; ++i) add(5.0 + 0.1 * i, CellState::kFree, none, 0.0);
  session.events = {{0.5, "contact", "first"},
                    {0.7, "warning", "slip: 1.2 um"},
                    {5.3, "contact", "second"},
                    {5.4, "note", "<b>ours</b>"}};
  session.profile.name = "mouse-oocyte";
  session.complete = true;
  return session;
}

TEST(RecordedSession, AStepIsFoundByItsTime) {
  const RecordedSession session = two_touches();
  EXPECT_EQ(session.step_at(-1.0), 0U);
  EXPECT_EQ(session.step_at(0.5), 5U);
  EXPECT_EQ(session.step_at(0.55), 5U);
  EXPECT_EQ(session.step_at(3.0), 11U);
  EXPECT_EQ(session.step_at(99.0), session.step_count() - 1);
  EXPECT_NEAR(session.usual_step_s(), 0.1, 1e-9);
}

TEST(RecordedSession, TheHeaderNamesItsFactsAndWhatSpeaksAgainstIt) {
  const TemporaryFolder folder;
  const auto path = folder / "S";
  test::write_session(path, 3);
  const RecordedSession session = recorded_session(SessionReader(path));
  const std::string facts = session_facts(session);
  for (const char* fact : {"mouse-oocyte", "0.825", "3 frames", "complete"}) {
    EXPECT_NE(facts.find(fact), std::string::npos) << facts;
  }
  EXPECT_EQ(session_caution(session), "");
  RecordedSession broken = session;
  broken.complete = false;
  broken.skipped_row_count = 2;
  EXPECT_NE(session_facts(broken).find("interrupted"), std::string::npos);
  EXPECT_NE(session_caution(broken).find("interrupted"), std::string::npos);
  EXPECT_NE(session_caution(broken).find("2 rows"), std::string::npos);
  EXPECT_EQ(session_name_of("/data/one/"), "one");
}

TEST(RecordedSession, OneWithoutARowIsRefused) {
  const TemporaryFolder folder;
  test::write_session(folder / "S", 0);
  EXPECT_THROW(recorded_session(SessionReader(folder / "S")), InputError);
}

TEST(ReviewEvents, EventsAndDoubtsComeInTheOrderOfTime) {
  RecordedSession session = two_touches();
  session.rows[1].confidence = 0.2;
  const auto events = review_events(session);
  EXPECT_TRUE(std::is_sorted(events.begin(), events.end(), [](auto& a, auto& b) { return a.time_s < b.time_s; }));
  const auto find = [&](const std::string& part) {
    return std::find_if(events.begin(), events.end(), [&](const auto& e) { return e.text.find(part) == 0; });
  };
  const auto warning = find("slip");
  ASSERT_NE(warning, events.end());
  EXPECT_TRUE(warning->is_doubt);
  EXPECT_DOUBLE_EQ(warning->end_s, 1.0);
  const auto unmeasured = find("3 frames recorded but not measured");
  ASSERT_NE(unmeasured, events.end());
  EXPECT_DOUBLE_EQ(unmeasured->time_s, 5.0);
  EXPECT_DOUBLE_EQ(unmeasured->end_s, 5.3);
  EXPECT_NE(find("contact without a force in 1 frame"), events.end());
  EXPECT_NE(find("confidence below 50 % in 1 frame"), events.end());
  EXPECT_EQ(kinds_of(events), (std::vector<std::string>{"contact", "warning", "note", "doubt"}));
}

TEST(ReviewEvents, DoubtsHoldForTheirTimeOnly) {
  const auto events = review_events(two_touches());
  EXPECT_EQ(doubts_at(events, 0.6), "");
  EXPECT_EQ(doubts_at(events, 0.7), "slip: 1.2 um");
  EXPECT_EQ(doubts_at(events, 0.9), "slip: 1.2 um");
  EXPECT_EQ(doubts_at(events, 1.0), "");
  EXPECT_NE(doubts_at(events, 5.5), "");
}

TEST(ReviewEvents, TheNeighbourIsTheNearestOnEitherSide) {
  const RecordedSession session = two_touches();
  const auto events = review_events(session);
  EXPECT_EQ(neighbour_event_step(session, events, 0, true), 5U);
  EXPECT_EQ(neighbour_event_step(session, events, 5, true), 7U);
  EXPECT_EQ(neighbour_event_step(session, events, 6, false), 5U);
  EXPECT_EQ(neighbour_event_step(session, events, 5, false), 5U);
  EXPECT_EQ(neighbour_event_step(session, events, 21, true), 21U);
}

TEST(Timeline, StatesAreStretchesAndWhatWasNotRecordedIsAHole) {
  const RecordedSession session = two_touches();
  const Timeline timeline = timeline_of(session, review_events(session));
  ASSERT_EQ(timeline.spans.size(), 6U);
  EXPECT_EQ(timeline.spans[1].state, CellState::kContact);
  EXPECT_DOUBLE_EQ(timeline.spans[1].begin_s, 0.5);
  EXPECT_DOUBLE_EQ(timeline.spans[1].end_s, 1.0);
  // The hole between 1.2 and 5 s.
  EXPECT_NEAR(timeline.spans[2].end_s, 1.2, 1e-9);
  EXPECT_FALSE(timeline.spans[3].state);
  EXPECT_DOUBLE_EQ(timeline.spans[3].begin_s, 5.0);
  EXPECT_EQ(states_in(timeline), (std::vector{CellState::kFree, CellState::kContact}));
}

TEST(Timeline, ATipSaysWhatIsThere) {
  const RecordedSession session = two_touches();
  const Timeline timeline = timeline_of(session, review_events(session));
  EXPECT_EQ(timeline_tip(timeline, 3.0, 0.01), "3.00 s: nothing recorded");
  const std::string tip = timeline_tip(timeline, 0.51, 0.05);
  EXPECT_NE(tip.find("Contact"), std::string::npos) << tip;
  EXPECT_NE(tip.find("contact: first"), std::string::npos) << tip;
  EXPECT_NE(timeline_tip(timeline, 5.1, 0.0).find("not measured"), std::string::npos);
}

TEST(Timeline, OneStepHasAWidth) {
  RecordedSession session = two_touches();
  session.rows.resize(1);
  session.times_s.resize(1);
  const Timeline timeline = timeline_of(session, {});
  EXPECT_GT(timeline.end_s, timeline.begin_s);
  EXPECT_EQ(timeline.spans.size(), 1U);
}

TEST(SessionCurves, TheForceOverTimeIsTheRecordedOneWithAGap) {
  const RecordedSession session = two_touches();
  const CurveChartData data = force_over_time(session);
  // Five forces, a gap, four forces.
  ASSERT_EQ(data.curve.size(), 10U);
  EXPECT_DOUBLE_EQ(data.curve.y[0], 0.5);
  EXPECT_TRUE(std::isnan(data.curve.y[5]));
  EXPECT_DOUBLE_EQ(data.curve.upper[9], 1.2 * 1.4);
  // The whole, and in it what the picture leaves open.
  ASSERT_EQ(data.inner.size(), 10U);
  EXPECT_DOUBLE_EQ(data.inner.upper[9], 1.05 * 1.4);
  EXPECT_TRUE(std::isnan(data.inner.y[5]));
  EXPECT_DOUBLE_EQ(data.x_end, session.end_s());
  ASSERT_EQ(data.marks.size(), 2U);
  EXPECT_DOUBLE_EQ(data.marks[1].x, 5.3);
}

TEST(RecordedSession, TheScaleOfAFrameIsTheCellsOwnOnceItWasMeasured) {
  RecordedSession session = two_touches();
  session.scale_ratio = 1.2;
  Measurement& row = session.rows[7];
  ForceRemarks remarks;
  add_scale(session, row, remarks);
  EXPECT_FALSE(remarks.has_own_scale);
  row.puncture_probability = 0.01;
  row.contact_force_scale_lower_uN = row.contact_force_uN * std::exp(-1.96 * 0.08);
  row.contact_force_scale_upper_uN = row.contact_force_uN * std::exp(1.96 * 0.08);
  add_scale(session, row, remarks);
  EXPECT_TRUE(remarks.has_own_scale);
  EXPECT_EQ(remarks.scale_ratio, 1.2);
  EXPECT_NEAR(remarks.scale_sigma_ratio, 0.08, 1e-12);
}

TEST(SessionCurves, ASessionOfAnEarlierVersionHasOneBand) {
  RecordedSession session = two_touches();
  for (Measurement& row : session.rows) {
    row.contact_force_picture_lower_uN = row.contact_force_picture_upper_uN = Measurement::kNotMeasured;
  }
  EXPECT_TRUE(force_over_time(session).inner.empty());
  EXPECT_TRUE(force_over_indentation(session, 16).inner.empty());
  EXPECT_DOUBLE_EQ(force_over_time(session).curve.upper[9], 1.2 * 1.4);
}

TEST(SessionCurves, TheTouchOfTheFrameIsInFrontOfTheOthers) {
  const RecordedSession session = two_touches();
  EXPECT_EQ(touch_of(session, 0), 0U);
  EXPECT_EQ(touch_of(session, 7), 1U);
  EXPECT_EQ(touch_of(session, 12), 1U);
  EXPECT_EQ(touch_of(session, 16), 2U);
  const CurveChartData first = force_over_indentation(session, 7), second = force_over_indentation(session, 16);
  EXPECT_EQ(first.curve.size(), 5U);
  EXPECT_EQ(second.curve.size(), 4U);
  EXPECT_EQ(second.inner.size(), 4U);
  EXPECT_EQ(second.faint.size(), 5U);
  EXPECT_TRUE(force_over_indentation(session, 0).curve.empty());
}

TEST(SurfaceNode, SaysWhatTheSurfaceHolds) {
  const auto node = surface_node(test::make_surface(4), 2);
  ASSERT_TRUE(node);
  EXPECT_EQ(node->membrane, Membrane::kInner);
  EXPECT_DOUBLE_EQ(node->force_uN[1], 25.0);
  EXPECT_NEAR(node->force_magnitude_uN, std::hypot(24.0, 25.0, 26.0), 1e-9);
  EXPECT_DOUBLE_EQ(node->force_sigma_uN, 12.0);
  EXPECT_DOUBLE_EQ(node->tension_uN_per_um, 48.0);
  EXPECT_FALSE(surface_node(test::make_surface(4), 4));
  EXPECT_FALSE(surface_node(nullptr, 0));
}

TEST(SurfaceNode, WhatIsMissingIsADash) {
  auto surface = test::make_surface(4);
  surface->GetPointData()->RemoveArray(array_name::kForceSigma);
  surface->GetPointData()->RemoveArray(array_name::kTension);
  for (const NodeFact& fact : node_facts(*surface_node(surface, 2))) {
    const bool missing = fact.name == "95 %" || fact.name == "Sigma" || fact.name == "Tension";
    EXPECT_EQ(fact.value == "\u2013", missing) << fact.name << ": " << fact.value;
  }
}

TEST(NodeHistory, HoldsEveryStepAndNamesWhatCantBeRead) {
  const TemporaryFolder folder;
  const auto path = folder / "S";
  test::write_session(path, 5);
  test::put(path / "surface" / "surface_00000002.vtp", "broken");
  std::size_t asked = 0;
  const NodeHistory history = read_node_history(path, 1, [&](std::size_t done, std::size_t all) {
    EXPECT_EQ(done, ++asked);
    EXPECT_EQ(all, 5U);
    return true;
  });
  EXPECT_TRUE(history.whole);
  EXPECT_EQ(history.unreadable_count, 1U);
  ASSERT_EQ(history.states.size(), 5U);
  EXPECT_DOUBLE_EQ(history.states[3].tension_uN_per_um, 26.0);
  EXPECT_TRUE(std::isnan(history.states[2].tension_uN_per_um));
  const CurveChartData data = node_over_time(history, NodeArray::kForce);
  ASSERT_EQ(data.curve.size(), 5U);
  EXPECT_TRUE(std::isnan(data.curve.y[2]));
  EXPECT_GT(data.curve.upper[4], data.curve.y[4]);
  // Tension has no sigma of its own.
  const CurveChartData tension = node_over_time(history, NodeArray::kTension);
  EXPECT_EQ(tension.curve.upper[4], tension.curve.y[4]);
}

TEST(NodeHistory, EndsWhenItIsTold) {
  const TemporaryFolder folder;
  test::write_session(folder / "S", 5);
  const NodeHistory history =
      read_node_history(folder / "S", 1, [](std::size_t done, std::size_t) { return done < 2; });
  EXPECT_FALSE(history.whole);
  EXPECT_EQ(history.states.size(), 2U);
}

TEST(NodeHistory, TheMeridianGoesThroughTheNodeOnItsMembrane) {
  // Directions at rest: pole, two on one meridian, one on another; the last on the other membrane.
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> direction, force, axis;
  vtkNew<vtkIntArray> membrane;
  direction->SetName(array_name::kRestDirection);
  direction->SetNumberOfComponents(3);
  force->SetName(array_name::kTension);
  membrane->SetName(array_name::kMembrane);
  const double polar_deg[] = {0.0, 90.0, 45.0, 60.0, 120.0}, azimuth_deg[] = {0.0, 30.0, 30.0, 80.0, 30.0};
  for (int i = 0; i < 5; ++i) {
    const double polar = polar_deg[i] * M_PI / 180.0, azimuth = azimuth_deg[i] * M_PI / 180.0;
    const double d[3] = {std::cos(polar), std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth)};
    points->InsertNextPoint(d);
    direction->InsertNextTuple(d);
    force->InsertNextValue(i);
    membrane->InsertNextValue(i == 4 ? 1 : 0);
  }
  axis->SetName(array_name::kAxis);
  axis->SetNumberOfComponents(3);
  const double x[3] = {1.0, 0.0, 0.0};
  axis->InsertNextTuple(x);
  surface->SetPoints(points);
  for (vtkDataArray* array : {static_cast<vtkDataArray*>(direction), static_cast<vtkDataArray*>(force),
                              static_cast<vtkDataArray*>(membrane)}) {
    surface->GetPointData()->AddArray(array);
  }
  EXPECT_TRUE(along_meridian(surface, 1, NodeArray::kTension).curve.empty());
  surface->GetFieldData()->AddArray(axis);
  const Curve curve = along_meridian(surface, 1, NodeArray::kTension).curve;
  EXPECT_EQ(curve.y, (std::vector<double>{0.0, 2.0, 1.0}));
  EXPECT_NEAR(curve.x[1], 45.0, 1e-6);
  EXPECT_NEAR(polar_angle_deg(surface, 3), 60.0, 1e-6);
  EXPECT_TRUE(along_meridian(surface, 77, NodeArray::kTension).curve.empty());
}

TEST(StepLoader, ReadsTheNewestRequestAndNamesDamage) {
  const TemporaryFolder folder;
  const auto path = folder / "S";
  test::write_session(path, 4);
  test::put(path / "surface" / "surface_00000002.vtp", "broken");
  StepLoader loader{SessionReader(path)};
  std::optional<LoadedStep> newest;
  const auto read = [&](std::size_t step) {
    loader.request(step);
    EXPECT_TRUE(loader.busy());
    return test::wait_until([&] {
      if (auto loaded = loader.take()) newest = std::move(loaded);
      return !loader.busy();
    });
  };
  ASSERT_TRUE(read(3));
  EXPECT_EQ(newest->step, 3U);
  EXPECT_EQ(newest->error, "");
  ASSERT_TRUE(newest->scene.observation);
  EXPECT_DOUBLE_EQ(newest->scene.measurement.contact_force_uN, 1.5);
  ASSERT_TRUE(read(2));
  EXPECT_NE(newest->error.find("surface_00000002"), std::string::npos) << newest->error;
  EXPECT_EQ(newest->scene.measurement.frame, 2);
  ASSERT_TRUE(read(1));
  EXPECT_EQ(newest->error, "");
}

}  // namespace
}  // namespace pellucida
