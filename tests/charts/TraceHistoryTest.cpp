#include "pellucida/charts/TraceHistory.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

Measurement row(double time_s, CellState state, double indentation_um, double force_uN) {
  Measurement m;
  m.time_s = time_s;
  m.state = state;
  m.indentation_um = indentation_um;
  m.contact_force_uN = force_uN;
  return m;
}

TEST(TraceHistory, LeavesOutRowsWithoutAForce) {
  TraceHistory history;
  history.append(Measurement{});
  EXPECT_TRUE(history.over_time().empty());
  history.append(row(0.1, CellState::kFree, 0.0, 0.0));
  EXPECT_EQ(history.over_time().size(), 1U);
  EXPECT_DOUBLE_EQ(history.over_time()[0].upper_uN, 0.0);
}

TEST(TraceHistory, ANewTouchKeepsTheOneBefore) {
  TraceHistory history;
  for (int i = 0; i < 10; ++i) history.append(row(i, CellState::kContact, i, 0.1 * i));
  history.append(row(10, CellState::kFree, 0.0, 0.0));
  EXPECT_FALSE(history.in_touch());
  EXPECT_EQ(history.current_touch().size(), 10U);
  history.append(row(11, CellState::kContact, 1.0, 0.1));
  EXPECT_EQ(history.previous_touch().size(), 10U);
  EXPECT_TRUE(history.in_touch());
  ASSERT_EQ(history.current_touch().size(), 1U);
  EXPECT_DOUBLE_EQ(history.current_touch()[0].indentation_um, 1.0);
  EXPECT_EQ(history.over_time().size(), 12U);
}

// Until the puncture is seen they show, and after it they are known for what they are.
TEST(TraceHistory, APunctureLeavesOutTheMembranesWayBack) {
  TraceHistory history;
  for (int i = 0; i < 30; ++i) history.append(row(i / 30.0, CellState::kContact, i, 0.1 * i));
  history.append(row(30 / 30.0, CellState::kContact, 24.0, 2.9));
  history.append(row(31 / 30.0, CellState::kContact, 20.0, 2.9));
  EXPECT_EQ(history.current_touch().size(), 32U);
  history.append(row(32 / 30.0, CellState::kPunctured, 5.0, 0.0));
  EXPECT_EQ(history.current_touch().size(), 30U);
  EXPECT_EQ(history.over_time().size(), 33U);
  // A needle drawn back slowly before is on the curve.
  TraceHistory slow;
  for (int i = 0; i < 30; ++i) slow.append(row(i / 3.0, CellState::kContact, 30 - i, 0.1 * (30 - i)));
  slow.append(row(10.0, CellState::kPunctured, 1.0, 0.0));
  EXPECT_EQ(slow.current_touch().size(), 30U);
}

TEST(TraceHistory, APassingLossDoesNotEndATouch) {
  TraceHistory history;
  for (int i = 0; i < 5; ++i) history.append(row(i, CellState::kContact, i, 0.1 * i));
  history.append(row(5, CellState::kLost, 5.0, 0.5));
  for (int i = 6; i < 9; ++i) history.append(row(i, CellState::kContact, i, 0.1 * i));
  EXPECT_EQ(history.current_touch().size(), 8U);
  EXPECT_TRUE(history.previous_touch().empty());
}

TEST(TraceHistory, AFrameThatWasNotMeasuredIsNoPointAndEndsNothing) {
  TraceHistory history;
  Measurement unmeasured;
  for (int i = 0; i < 9; ++i) {
    if (i % 3 != 2) history.append(row(i, CellState::kContact, i, 0.1 * i));
    unmeasured.time_s = i;
    if (i % 3 == 2) history.append(unmeasured);
  }
  EXPECT_EQ(history.over_time().size(), 6U);
  EXPECT_EQ(history.current_touch().size(), 6U);
  EXPECT_TRUE(history.previous_touch().empty());
  EXPECT_TRUE(history.in_touch());
  EXPECT_EQ(history.marks().size(), 1U);
}

// 0.1 s a frame, in contact; frames 100 to 199 were not measured, and before them every second one.
TraceHistory with_a_gap(int rows) {
  TraceHistory history;
  for (int i = 0; i < rows; ++i) {
    Measurement m = row(0.1 * i, CellState::kContact, 0.01 * i, 0.001 * i);
    m.frame = i;
    if (i < 100 ? i % 2 == 1 : i < 200) m.state.reset();
    history.append(m);
  }
  return history;
}

TEST(TraceHistory, ALongStretchWithoutAForceIsAGapAndAFrameIsNone) {
  const TraceHistory history = with_a_gap(300);
  for (const auto* points : {&history.over_time(), &history.current_touch()}) {
    ASSERT_EQ(points->size(), 150U);
    for (std::size_t i = 0; i < points->size(); ++i) EXPECT_EQ((*points)[i].after_gap, i == 50) << i;
  }
}

TEST(TraceHistory, ThinningKeepsTheGap) {
  const TraceHistory history = with_a_gap(50000);
  EXPECT_LE(history.over_time().size(), TraceHistory::kMostPoints);
  int gaps = 0;
  for (const TracePoint& point : history.over_time()) {
    gaps += point.after_gap;
    if (point.after_gap) {
      EXPECT_GE(point.time_s, 20.0);
      EXPECT_LT(point.time_s, 30.0);
    }
  }
  EXPECT_EQ(gaps, 1);
}

TEST(TraceHistory, StaysBoundedAndKeepsFirstAndNewest) {
  TraceHistory history;
  constexpr int kRows = 50000;
  for (int i = 0; i < kRows; ++i) history.append(row(0.01 * i, CellState::kContact, 1.0, 1e-4 * i));
  EXPECT_LE(history.over_time().size(), TraceHistory::kMostPoints);
  EXPECT_GE(history.over_time().size(), TraceHistory::kMostPoints / 2);
  EXPECT_DOUBLE_EQ(history.over_time().front().time_s, 0.0);
  EXPECT_DOUBLE_EQ(history.over_time().back().time_s, 0.01 * (kRows - 1));
  for (std::size_t i = 1; i < history.over_time().size(); ++i) {
    ASSERT_GT(history.over_time()[i].time_s, history.over_time()[i - 1].time_s);
  }
}

TEST(TraceHistory, MarksContactPunctureAndLossOnce) {
  TraceHistory history;
  for (int i = 0; i < 3; ++i) history.append(row(i, CellState::kFree, 0.0, 0.0));
  for (int i = 3; i < 6; ++i) history.append(row(i, CellState::kContact, i, 0.1 * i));
  for (int i = 6; i < 9; ++i) history.append(row(i, CellState::kPunctured, 0.0, 0.0));
  for (int i = 9; i < 12; ++i) history.append(row(i, CellState::kFree, 0.0, 0.0));
  ASSERT_EQ(history.marks().size(), 2U);
  EXPECT_EQ(history.marks()[0].state, CellState::kContact);
  EXPECT_DOUBLE_EQ(history.marks()[0].time_s, 3.0);
  EXPECT_EQ(history.marks()[1].state, CellState::kPunctured);
  EXPECT_DOUBLE_EQ(history.marks()[1].time_s, 6.0);
  for (int i = 12; i < 1000; ++i) history.append(row(i, i % 2 ? CellState::kLost : CellState::kContact, 1.0, 0.0));
  EXPECT_EQ(history.marks().size(), TraceHistory::kMostMarks);
}

TEST(TraceHistory, TimeGoingBackStartsAfresh) {
  TraceHistory history;
  history.append(row(5.0, CellState::kContact, 1.0, 1.0));
  history.append(row(0.0, CellState::kContact, 2.0, 2.0));
  ASSERT_EQ(history.over_time().size(), 1U);
  EXPECT_DOUBLE_EQ(history.over_time()[0].force_uN, 2.0);
}

}  // namespace
}  // namespace pellucida
