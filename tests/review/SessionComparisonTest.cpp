// Two sessions whose rows are known, frame against frame.
#include "presenters/SessionComparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/TemporaryFolder.h"

namespace pellucida {
namespace {

constexpr double kNone = Measurement::kNotMeasured;

// Ten frames a second: free for so long, in to a depth of 20 um by so much a frame and out again, free. The force is a
// tenth of the depth times the stiffness, its interval +-10 %.
RecordedSession in_and_out(int free_frames, double step_um, double stiffness, double begin_s = 0.0) {
  RecordedSession session;
  const auto add = [&](CellState state, double depth_um) {
    Measurement row;
    row.frame = static_cast<long>(session.rows.size());
    row.time_s = begin_s + 0.1 * static_cast<double>(row.frame);
    row.state = state;
    row.indentation_um = depth_um;
    row.contact_force_uN = state == CellState::kContact ? 0.1 * stiffness * depth_um : kNone;
    row.contact_force_lower_uN = 0.9 * row.contact_force_uN;
    row.contact_force_upper_uN = 1.1 * row.contact_force_uN;
    session.rows.push_back(row);
    session.times_s.push_back(row.time_s);
  };
  for (int i = 0; i < free_frames; ++i) add(CellState::kFree, 0.0);
  for (double depth_um = step_um; depth_um < 20.01; depth_um += step_um) add(CellState::kContact, depth_um);
  for (double depth_um = 20.0 - step_um; depth_um > 0.01; depth_um -= step_um) add(CellState::kContact, depth_um);
  for (int i = 0; i < 5; ++i) add(CellState::kFree, 0.0);
  return session;
}

TEST(SessionComparison, TheSameTimeIsCountedFromEachBeginning) {
  const RecordedSession shown = in_and_out(5, 2.0, 1.0), other = in_and_out(5, 2.0, 1.5, 100.0);
  const SessionComparison comparison(shown, other);
  for (std::size_t step = 0; step < shown.step_count(); ++step)
    EXPECT_EQ(comparison.partner(step, Alignment::kTime), step);
}

TEST(SessionComparison, ARecordingThatEndedBeforeHasNoPartner) {
  const RecordedSession shown = in_and_out(5, 1.0, 1.0), other = in_and_out(5, 2.0, 1.0);
  const SessionComparison comparison(shown, other);
  EXPECT_EQ(comparison.partner(other.step_count() - 1, Alignment::kTime), other.step_count() - 1);
  EXPECT_FALSE(comparison.partner(other.step_count() + 1, Alignment::kTime));
}

TEST(SessionComparison, TimeSinceContactFindsALateTouch) {
  const RecordedSession shown = in_and_out(5, 2.0, 1.0), other = in_and_out(12, 2.0, 1.0);
  const SessionComparison comparison(shown, other);
  EXPECT_EQ(comparison.partner(5, Alignment::kContact), 12U);
  EXPECT_EQ(comparison.partner(9, Alignment::kContact), 16U);
  EXPECT_EQ(comparison.partner(3, Alignment::kContact), 10U);  // before it, too
  const CurveChartData difference = comparison.difference(9, Alignment::kContact);
  ASSERT_GT(difference.curve.size(), 10U);
  for (const double value : difference.curve.y) EXPECT_NEAR(value, 0.0, 1e-12);
}

TEST(SessionComparison, TheSameIndentationIsOnTheSameWay) {
  // Twice as fast, so that every second frame of the slow one has one.
  const RecordedSession shown = in_and_out(5, 1.0, 1.0), other = in_and_out(3, 2.0, 1.2);
  const SessionComparison comparison(shown, other);
  const auto at = [&](std::size_t step) { return comparison.partner(step, Alignment::kIndentation); };
  EXPECT_FALSE(at(2));      // free
  EXPECT_EQ(at(8), 4U);     // 4 um, on the way in
  EXPECT_EQ(at(24), 12U);   // 20 um
  const auto out = at(40);  // 4 um, on the way out
  ASSERT_TRUE(out);
  EXPECT_EQ(*out, 20U);
  EXPECT_DOUBLE_EQ(other.rows[*out].indentation_um, shown.rows[40].indentation_um);
}

TEST(SessionComparison, ADepthThatTheOtherNeverReachedHasNoPartner) {
  RecordedSession other = in_and_out(5, 2.0, 1.0);
  for (Measurement& row : other.rows) row.indentation_um = std::min(row.indentation_um, 10.0);
  const RecordedSession shown = in_and_out(5, 2.0, 1.0);
  const SessionComparison comparison(shown, other);
  EXPECT_TRUE(comparison.partner(9, Alignment::kIndentation));    // 10 um
  EXPECT_FALSE(comparison.partner(10, Alignment::kIndentation));  // 12 um
}

TEST(SessionComparison, TheDifferenceByDepthIsThatOfTheStiffness) {
  const RecordedSession shown = in_and_out(5, 2.0, 1.0), other = in_and_out(8, 2.0, 1.5);
  const SessionComparison comparison(shown, other);
  const CurveChartData difference = comparison.difference(8, Alignment::kIndentation);
  ASSERT_EQ(difference.curve.size(), 10U);
  for (std::size_t k = 0; k < difference.curve.size(); ++k) {
    const double depth_um = difference.curve.x[k];
    EXPECT_NEAR(depth_um, 2.0 * static_cast<double>(k + 1), 1e-9);
    EXPECT_NEAR(difference.curve.y[k], 0.05 * depth_um, 1e-9);
    // Ten per cent of each, as independent errors add.
    const double half_uN = 0.01 * depth_um * std::hypot(1.0, 1.5);
    EXPECT_NEAR(difference.curve.upper[k] - difference.curve.y[k], half_uN, 1e-9);
    EXPECT_NEAR(difference.curve.y[k] - difference.curve.lower[k], half_uN, 1e-9);
  }
}

TEST(SessionComparison, TheOtherCurveLiesWhereItsPartnersAre) {
  const RecordedSession shown = in_and_out(5, 2.0, 1.0), other = in_and_out(12, 2.0, 1.5, 50.0);
  const SessionComparison comparison(shown, other);
  const Curve by_time = comparison.other_over_time(Alignment::kTime);
  EXPECT_NEAR(by_time.x.front(), 1.2, 1e-9);
  const Curve by_contact = comparison.other_over_time(Alignment::kContact);
  EXPECT_NEAR(by_contact.x.front(), 0.5, 1e-9);
  EXPECT_NEAR(by_contact.y.front(), 0.3, 1e-9);
}

TEST(SessionComparison, TheTableNamesBothAndTheDifference) {
  const RecordedSession shown = in_and_out(5, 2.0, 1.0), other = in_and_out(5, 2.0, 1.5);
  const SessionComparison comparison(shown, other);
  const auto rows = comparison.rows(9, 9);
  const auto row = [&](const std::string& name) {
    for (const ComparisonRow& candidate : rows)
      if (candidate.name == name) return candidate;
    return ComparisonRow{};
  };
  EXPECT_EQ(row("Force").shown, "1.00 µN");
  EXPECT_EQ(row("Force").other, "1.50 µN");
  EXPECT_EQ(row("Force").difference, "+0.50 µN");
  EXPECT_EQ(row("Indentation").difference, "0.0 µm");
  EXPECT_EQ(row("95 %").difference, "0.32 – 0.68 µN");
  const auto alone = comparison.rows(9, std::nullopt);
  EXPECT_EQ(alone[3].other, "–");
  EXPECT_EQ(alone[3].difference, "");
}

TEST(SessionComparison, TheTableOnDiskIsTheChart) {
  const RecordedSession shown = in_and_out(5, 2.0, 1.0), other = in_and_out(5, 2.0, 1.5);
  const SessionComparison comparison(shown, other);
  const TemporaryFolder folder;
  comparison.write_difference(8, Alignment::kIndentation, folder / "d.csv");
  const Table table = Table::read(folder / "d.csv");
  ASSERT_EQ(table.rows(), 10);
  EXPECT_NEAR(table.column("indentation_um")[9], 20.0, 1e-9);
  EXPECT_NEAR(table.column("other_force_uN")[9], 3.0, 1e-9);
  EXPECT_NEAR(table.column("difference_uN")[9], 1.0, 1e-9);
  EXPECT_NEAR(table.column("difference_lower_uN")[9], 1.0 - 0.2 * std::hypot(1.0, 1.5), 1e-9);
  EXPECT_THROW(comparison.write_difference(8, Alignment::kTime, "/no/such/folder/d.csv"), OutputError);
}

TEST(SessionComparison, WithoutATouchThereIsNothingToCompareByDepth) {
  RecordedSession free = in_and_out(5, 2.0, 1.0);
  for (Measurement& row : free.rows) {
    row.state = CellState::kFree;
    row.contact_force_uN = kNone;
  }
  const RecordedSession shown = in_and_out(5, 2.0, 1.0);
  const SessionComparison comparison(shown, free), turned(free, shown);
  for (const SessionComparison* each : {&comparison, &turned}) {
    EXPECT_FALSE(each->partner(8, Alignment::kContact));
    EXPECT_FALSE(each->partner(8, Alignment::kIndentation));
    EXPECT_TRUE(each->difference(8, Alignment::kIndentation).curve.empty());
  }
  EXPECT_TRUE(comparison.other_over_indentation(8).empty());
  // The other one's first touch is shown all the same.
  EXPECT_FALSE(turned.other_over_indentation(8).empty());
}

}  // namespace
}  // namespace pellucida
