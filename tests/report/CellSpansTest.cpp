#include "CellSpans.h"

#include <gtest/gtest.h>

#include "SyntheticRows.h"

namespace pellucida {
namespace {

using test::linear;
using test::SyntheticRows;

// Two pushes with something between them; how many cells and contacts that makes.
struct Between {
  std::size_t cells = 0, contacts_of_first = 0;
  int losses = 0;
  std::vector<CellPassport> passports;
};
Between with_between(const std::function<void(SyntheticRows&)>& between) {
  SyntheticRows rows;
  rows.approach();
  rows.push(1.0, 10.0, linear);
  rows.push(9.5, 1.0, linear);
  rows.approach(5);
  between(rows);
  rows.approach(5);
  rows.push(1.0, 5.0, linear);
  rows.approach(3);
  auto passports = rows.passports();
  return {passports.size(), passports[0].contact_list.size(), passports[0].losses, passports};
}

TEST(CellSpans, TwoContactsOfOneCell) {
  const auto found = with_between([](SyntheticRows&) {});
  EXPECT_EQ(found.cells, 1U);
  EXPECT_EQ(found.contacts_of_first, 2U);
  EXPECT_EQ(found.losses, 0);
  // The deeper one is the cell's.
  EXPECT_EQ(found.passports[0].main_contact().contact, 1);
  EXPECT_DOUBLE_EQ(found.passports[0].main_contact().peak_force_uN, 1.0);
  EXPECT_EQ(found.passports[0].contact_list[1].contact, 2);
}

TEST(CellSpans, LostAndFoundAgainIsTheSameCell) {
  const auto found = with_between([](SyntheticRows& rows) { rows.lost(30); });
  EXPECT_EQ(found.cells, 1U);
  EXPECT_EQ(found.losses, 1);
  EXPECT_TRUE(test::mentions(found.passports[0].doubt_list, "out of sight for 1.0 s"));
}

TEST(CellSpans, WhatIsFoundLateElsewhereOrOfAnotherSizeIsAnotherCell) {
  const auto late = with_between([](SyntheticRows& rows) { rows.lost(200); });
  EXPECT_EQ(late.cells, 2U);
  EXPECT_TRUE(test::mentions(late.passports[1].doubt_list, "found after 6.7 s without a cell"));
  EXPECT_EQ(with_between([](SyntheticRows& rows) {
              rows.lost(30);
              rows.cell_x_um += 30.0;
            }).cells,
            2U);
  EXPECT_EQ(with_between([](SyntheticRows& rows) {
              rows.lost(30);
              rows.cell_x_um += 20.0;
            }).cells,
            1U);
  EXPECT_EQ(with_between([](SyntheticRows& rows) {
              rows.lost(30);
              rows.radius_um = 53.0;
            }).cells,
            2U);
}

TEST(CellSpans, NoCellInViewANoteANewRunAndAClockThatGoesBackEndACell) {
  EXPECT_EQ(with_between([](SyntheticRows& rows) { rows.add(CellState::kNoCell); }).cells, 2U);
  EXPECT_EQ(with_between([](SyntheticRows& rows) { rows.event(event_kind::kNote, "new cell, dish 2"); }).cells, 2U);
  EXPECT_EQ(with_between([](SyntheticRows& rows) { rows.event(event_kind::kNote, "nice cell"); }).cells, 1U);

  SyntheticRows rows;
  rows.approach(4);
  rows.approach(4);
  PassportInput input = rows.input();
  input.run_starts = {4};
  EXPECT_EQ(find_cells(input).size(), 2U);
  input.run_starts = {};
  rows.row(4).time_s = 0.0;
  EXPECT_EQ(find_cells(rows.input()).size(), 2U);
}

TEST(CellSpans, NothingSeenIsNoCell) {
  EXPECT_TRUE(SyntheticRows().passports().empty());
  SyntheticRows rows;
  for (int i = 0; i < 5; ++i) rows.add(CellState::kNoCell);
  rows.add(std::nullopt);
  EXPECT_TRUE(rows.passports().empty());
}

// A frame nobody measured ends neither a contact nor a cell.
TEST(CellSpans, UnmeasuredFramesEndNothing) {
  SyntheticRows rows;
  rows.approach();
  rows.push(1.0, 10.0, linear);
  for (int i = 0; i < 20; ++i) rows.add(std::nullopt);
  rows.push(10.0, 20.0, linear);
  rows.approach(2);
  const auto cells = rows.passports();
  ASSERT_EQ(cells.size(), 1U);
  ASSERT_EQ(cells[0].contacts, 1);
  EXPECT_EQ(cells[0].contact_list[0].unmeasured_frames, 20);
}

TEST(CellSpans, HowAContactEnds) {
  const auto outcome_after = [](const std::function<void(SyntheticRows&)>& end) {
    SyntheticRows rows;
    rows.approach();
    rows.push(1.0, 10.0, linear);
    end(rows);
    return rows.passports().at(0).contact_list.at(0);
  };
  const auto retracted = outcome_after([](SyntheticRows& rows) { rows.approach(1); });
  EXPECT_EQ(retracted.outcome, "retracted");
  EXPECT_NEAR(retracted.dwell_s, 19.0 / 30.0, 1e-9);  // 1 to 10 um in halves: 19 frames, then the free one
  EXPECT_EQ(outcome_after([](SyntheticRows& rows) { rows.lost(3); }).outcome, "lost");
  EXPECT_EQ(outcome_after([](SyntheticRows&) {}).outcome, "unfinished");
  const auto lost = outcome_after([](SyntheticRows& rows) {
    rows.lost(10);
    rows.approach(3);
  });
  EXPECT_EQ(lost.outcome, "lost");
  EXPECT_TRUE(std::isnan(lost.release_s));
  // In contact again after a loss: the same contact, with a doubt.
  const auto back = outcome_after([](SyntheticRows& rows) {
    rows.lost(10);
    rows.push(10.0, 12.0, linear);
    rows.approach(1);
  });
  EXPECT_EQ(back.outcome, "retracted");
  EXPECT_DOUBLE_EQ(back.largest_depth_um, 12.0);
  EXPECT_TRUE(test::mentions(back.doubt_list, "the cell was lost for 0.33 s of the contact"));
}

}  // namespace
}  // namespace pellucida
