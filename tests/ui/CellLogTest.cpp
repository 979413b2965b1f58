#include "presenters/CellLog.h"

#include <gtest/gtest.h>

#include "pellucida/core/CellNameNote.h"
#include "pellucida/core/NewCellNote.h"
#include "report/SyntheticRows.h"

namespace pellucida {
namespace {

using test::SyntheticRows;

TEST(CellLog, TheNextNameCountsOn) {
  EXPECT_EQ(next_cell_name(""), "A-1");
  EXPECT_EQ(next_cell_name("A-1"), "A-2");
  EXPECT_EQ(next_cell_name("oocyte 09"), "oocyte 10");
  EXPECT_EQ(next_cell_name("99"), "100");
  EXPECT_EQ(next_cell_name("left"), "left-2");
  EXPECT_EQ(next_cell_name("a12345678901234567890"), "a12345678901234567890-2") << "no number that can be counted";
}

// A cell that is pushed and let go, a new one, named; the log is fed piece by piece.
TEST(CellLog, IsWhatTheReportOfTheSameRowsSays) {
  SyntheticRows rows;
  rows.approach();
  rows.event(event_kind::kNote, std::string(kCellNameNote) + "B-7");
  rows.event(event_kind::kContact, "");
  rows.push(0.5, 20.0, test::linear);
  rows.push(19.5, 0.5, test::linear);
  rows.approach(5);
  rows.event(event_kind::kNote, std::string(kNewCellNote));
  rows.approach();
  const auto whole = rows.passports();
  ASSERT_EQ(whole.size(), 2U);

  CellLog log("mouse-oocyte");
  std::size_t event_count = 0;
  for (std::size_t k = 0; k < rows.size(); k += 10) {
    const auto part = std::span(rows.rows()).subspan(k, std::min<std::size_t>(10, rows.size() - k));
    std::vector<Event> events;
    for (; event_count < rows.events().size() && rows.events()[event_count].time_s <= part.back().time_s;
         ++event_count) {
      events.push_back(rows.events()[event_count]);
    }
    log.take(part, events);
    log.settle(CellLog::evaluate(log.pending()));
  }
  ASSERT_EQ(log.cells().size(), 2U);
  for (int k = 0; k < 2; ++k) {
    const CellRow now = cell_row(log.cells()[k]), then = cell_row(whole[k]);
    EXPECT_EQ(log.cells()[k].cell, k + 1);
    EXPECT_EQ(now.name, then.name);
    EXPECT_EQ(now.outcome, then.outcome);
    EXPECT_EQ(now.force, then.force);
    EXPECT_EQ(now.work, then.work);
  }
  EXPECT_EQ(cell_row(log.cells()[0]).name, "B-7");
  EXPECT_EQ(cell_row(log.cells()[0]).outcome, "retracted");
  EXPECT_EQ(cell_row(log.cells()[0]).force, "2.00");
  EXPECT_EQ(cell_row(log.cells()[1]).name, "2");
  EXPECT_EQ(cell_row(log.cells()[1]).force, "\u2013");
  EXPECT_TRUE(log.name().empty()) << "the new cell has none yet";
  EXPECT_EQ(log.suggested_name(), "B-8");
  EXPECT_LT(log.pending().rows.size(), rows.size()) << "settled cells are forgotten";
}

// What has settled keeps its name when the next evaluation comes, although no row lies between name and new cell.
TEST(CellLog, ANameGivenBetweenTwoRowsStays) {
  const SyntheticRows rows = SyntheticRows::named_without_a_row();
  CellLog log("mouse-oocyte");
  log.take(rows.rows(), rows.events());
  for (int k = 0; k < 2; ++k) {
    log.settle(CellLog::evaluate(log.pending()));
    ASSERT_EQ(log.cells().size(), 2U);
    EXPECT_EQ(cell_row(log.cells()[0]).name, "A-1");
    EXPECT_EQ(cell_row(log.cells()[1]).name, "2");
  }
}

}  // namespace
}  // namespace pellucida
