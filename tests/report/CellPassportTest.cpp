#include "pellucida/report/CellPassport.h"

#include <gtest/gtest.h>

#include "SyntheticRows.h"
#include "pellucida/core/CellNameNote.h"
#include "pellucida/core/NewCellNote.h"
#include "pellucida/mechanics/ForceEstimate.h"
#include "pellucida/report/PassportReport.h"

namespace pellucida {
namespace {

using test::linear;
using test::mentions;
using test::square;
using test::SyntheticRows;

ContactPassport only_contact(const SyntheticRows& rows) {
  const auto cells = rows.passports();
  EXPECT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells.at(0).contacts, 1);
  return cells.at(0).contact_list.at(0);
}

// In and out again; the way out along a softer line.
SyntheticRows push_and_pull(double depth_um, const SyntheticRows::Curve& in, const SyntheticRows::Curve& out) {
  SyntheticRows rows;
  rows.approach();
  rows.push(0.5, depth_um, in);
  rows.push(depth_um - 0.5, 0.5, out);
  rows.approach(3);
  return rows;
}

TEST(CellPassport, WorkStiffnessAndPeakOfALinearCell) {
  const auto contact = only_contact(push_and_pull(40.0, linear, linear));
  EXPECT_DOUBLE_EQ(contact.peak_force_uN, 4.0);
  EXPECT_DOUBLE_EQ(contact.peak_force_lower_uN, 3.6);
  EXPECT_DOUBLE_EQ(contact.peak_force_upper_uN, 4.4);
  EXPECT_DOUBLE_EQ(contact.peak_force_depth_um, 40.0);
  EXPECT_NEAR(contact.peak_force_s - contact.touch_s, 79.0 / 30.0, 1e-9);
  EXPECT_NEAR(contact.work_pJ, 80.0, 1e-9);
  EXPECT_NEAR(contact.work_lower_pJ, 72.0, 1e-6);
  EXPECT_NEAR(contact.work_upper_pJ, 88.0, 1e-6);
  for (const double stiffness : {contact.stiffness_5um_uN_per_um, contact.stiffness_10um_uN_per_um,
                                 contact.stiffness_20um_uN_per_um, contact.stiffness_30um_uN_per_um}) {
    EXPECT_NEAR(stiffness, 0.1, 1e-9);
  }
  EXPECT_NEAR(contact.stiffness_20um_lower_uN_per_um, 0.09, 1e-9);
  EXPECT_NEAR(contact.stiffness_20um_upper_uN_per_um, 0.11, 1e-9);
  // Nobody went beyond 40 um: not reached, and not 0.
  EXPECT_TRUE(std::isnan(contact.stiffness_40um_uN_per_um));
  EXPECT_NEAR(contact.hysteresis_pJ, 0.0, 1e-9);
  EXPECT_TRUE(contact.doubt_list.empty()) << contact.doubts;
}

// Contours add up over a contact: the last frame in contact that has a stiffening says most, and one after it says
// nothing.
TEST(CellPassport, StrainStiffeningIsTheLastOfTheContact) {
  SyntheticRows rows;
  rows.approach();
  const std::size_t touch = rows.size();
  rows.push(0.5, 20.0, linear);
  for (const std::size_t after : {10, 30}) {
    Measurement& m = rows.row(touch + after);
    m.strain_stiffening = 0.01 * static_cast<double>(after);
    m.strain_stiffening_lower = m.strain_stiffening - 0.05;
    m.strain_stiffening_upper = m.strain_stiffening + 0.05;
  }
  rows.approach(3);
  rows.row(rows.size() - 1).strain_stiffening = 9.0;
  const auto contact = only_contact(rows);
  EXPECT_DOUBLE_EQ(contact.strain_stiffening, 0.3);
  EXPECT_DOUBLE_EQ(contact.strain_stiffening_lower, 0.25);
  EXPECT_DOUBLE_EQ(contact.strain_stiffening_upper, 0.35);
  EXPECT_TRUE(std::isnan(only_contact(push_and_pull(20.0, linear, linear)).strain_stiffening));
}

// A name given before the cell was found is its own; the last one counts; the note that begins another cell ends it.
TEST(CellPassport, ACellHasTheNameThatWasGivenLast) {
  SyntheticRows rows;
  const auto name = [&](const char* text) { rows.event(event_kind::kNote, std::string(kCellNameNote) + text); };
  name("A-0");
  rows.approach();
  name("A-1");
  rows.push(0.5, 10.0, linear);
  rows.approach(3);
  rows.event(event_kind::kNote, std::string(kNewCellNote));
  name("A-2");
  rows.approach();
  const auto cells = rows.passports();
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].name, "A-1");
  EXPECT_EQ(cells[0].contact_list.at(0).cell_name, "A-1");
  EXPECT_TRUE(cells[0].notes.empty()) << "a name is no remark";
  EXPECT_EQ(cells[1].name, "A-2");
  // Untouched, and yet in the table with its name.
  const std::string table = cells_csv(cells);
  EXPECT_NE(table.find(",A-1\n"), std::string::npos) << table;
  EXPECT_NE(table.find(",A-2\n"), std::string::npos) << table;
}

// The camera is late: no row comes between the name and the note that begins another cell.
TEST(CellPassport, ANameBeforeTheNoteOfANewCellIsNotHandedOn) {
  const auto cells = SyntheticRows::named_without_a_row().passports();
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].name, "A-1");
  EXPECT_EQ(cells[1].name, "");
  EXPECT_GT(cells[0].named_until_s, cells[0].last_seen_s);
}

TEST(CellPassport, StiffnessGrowsWithDepthWhereTheForceBends) {
  const auto contact = only_contact(push_and_pull(44.0, square, square));
  EXPECT_NEAR(contact.stiffness_5um_uN_per_um, 0.04, 0.002);
  EXPECT_NEAR(contact.stiffness_20um_uN_per_um, 0.16, 0.002);
  EXPECT_NEAR(contact.stiffness_40um_uN_per_um, 0.32, 0.002);
  EXPECT_NEAR(contact.work_pJ, 0.004 / 3.0 * std::pow(44.0, 3), 0.05);
}

// One frame in ten far off: the slope hardly moves, where least squares would take twice as much.
TEST(CellPassport, StiffnessTakesNoNoticeOfWildFrames) {
  SyntheticRows rows = push_and_pull(40.0, linear, linear);
  for (std::size_t i = 34; i < rows.size(); i += 10) rows.row(i).contact_force_uN += 3.0;
  const auto contact = only_contact(rows);
  EXPECT_NEAR(contact.stiffness_20um_uN_per_um, 0.1, 0.005);
  EXPECT_LT(contact.stiffness_20um_lower_uN_per_um, 0.1);
  EXPECT_GT(contact.stiffness_20um_upper_uN_per_um, 0.1);
}

TEST(CellPassport, HysteresisIsTheAreaBetweenInsertionAndRemoval) {
  const auto contact = only_contact(push_and_pull(40.0, linear, [](double depth_um) { return 0.05 * depth_um; }));
  // 80 pJ in; out 39.5 um along 0.05 uN/um, and the half micrometre on which the force falls.
  EXPECT_NEAR(contact.hysteresis_pJ, 80.0 - (0.5 * 0.05 * 39.5 * 39.5 + 0.5 * (4.0 + 0.05 * 39.5) * 0.5), 1e-9);
  EXPECT_NEAR(contact.hysteresis_lower_pJ, 0.9 * contact.hysteresis_pJ, 1e-6);
  EXPECT_NEAR(contact.hysteresis_upper_pJ, 1.1 * contact.hysteresis_pJ, 1e-6);
}

TEST(CellPassport, AnOpenRemovalHasNoHysteresis) {
  SyntheticRows rows;
  rows.approach();
  rows.push(0.5, 40.0, linear);
  rows.push(39.5, 25.0, linear);
  rows.approach(2);
  EXPECT_TRUE(std::isnan(only_contact(rows).hysteresis_pJ));
}

TEST(CellPassport, PunctureWithForceDepthWorkDropAndSpringBack) {
  SyntheticRows rows;
  rows.approach();
  rows.push(0.5, 44.0, linear);
  rows.punctured(60, 50.0, 2.0);
  rows.approach(3);
  const auto contact = only_contact(rows);
  EXPECT_EQ(contact.outcome, "punctured");
  EXPECT_NEAR(contact.puncture_s - contact.touch_s, 88.0 / 30.0, 1e-9);
  EXPECT_NEAR(contact.puncture_force_uN, 4.4, 1e-12);
  EXPECT_NEAR(contact.puncture_force_lower_uN, 3.96, 1e-12);
  EXPECT_NEAR(contact.puncture_depth_um, 44.0, 1e-12);
  EXPECT_NEAR(contact.puncture_work_pJ, 0.05 * 44.0 * 44.0, 1e-9);
  EXPECT_NEAR(contact.drop_uN, 4.4, 1e-12);
  EXPECT_NEAR(contact.spring_back_um, 42.0, 1e-12);
  EXPECT_NEAR(contact.inside_s, 2.0, 1e-9);
  EXPECT_NEAR(contact.dwell_s, 148.0 / 30.0, 1e-9);
  // No removal curve after a puncture.
  EXPECT_TRUE(std::isnan(contact.hysteresis_pJ));
  EXPECT_TRUE(contact.doubt_list.empty()) << contact.doubts;
}

// Noticed two frames late, when the force has begun to fall: the force at which it gave way is the one before.
TEST(CellPassport, APunctureNoticedLateKeepsItsForce) {
  SyntheticRows rows;
  rows.approach();
  rows.push(0.5, 40.0, linear);
  rows.seen(CellState::kContact, -40.0, 20.0, 2.0);
  rows.seen(CellState::kContact, -40.0, 10.0, 1.0);
  rows.punctured(10, 40.0);
  const auto contact = only_contact(rows);
  EXPECT_NEAR(contact.puncture_force_uN, 4.0, 1e-12);
  EXPECT_NEAR(contact.puncture_depth_um, 40.0, 1e-12);
}

// While it is in doubt the force stays, and only the membrane has begun to go back.
TEST(CellPassport, TheWayBackOfTheMembraneIsNoPartOfTheCurve) {
  SyntheticRows rows;
  rows.approach();
  rows.push(0.5, 40.0, linear);
  rows.seen(CellState::kContact, -40.0, 34.0, 4.05);
  rows.punctured(10, 40.0);
  const auto contact = only_contact(rows);
  EXPECT_NEAR(contact.puncture_force_uN, 4.0, 1e-12);
  EXPECT_NEAR(contact.puncture_depth_um, 40.0, 1e-12);
  EXPECT_NEAR(contact.puncture_work_pJ, 0.05 * 40.0 * 40.0, 1e-9);
}

TEST(CellPassport, ARevokedPunctureIsNone) {
  SyntheticRows rows;
  rows.approach();
  rows.push(0.5, 20.0, linear);
  rows.punctured(3, 20.0);
  rows.event(event_kind::kRevoked, "membrane and tip are together again at 20.5 um");
  rows.push(20.5, 40.0, linear);
  SyntheticRows whole = rows;
  whole.approach();
  const auto contact = only_contact(whole);
  EXPECT_EQ(contact.outcome, "retracted");
  EXPECT_TRUE(std::isnan(contact.puncture_s));
  EXPECT_NEAR(contact.peak_force_uN, 4.0, 1e-12);
  EXPECT_TRUE(mentions(contact.doubt_list, "was revoked"));
  EXPECT_FALSE(mentions(contact.doubt_list, "punctures in one contact"));

  rows.punctured(10, 45.0);
  const auto pierced = only_contact(rows);
  EXPECT_EQ(pierced.outcome, "punctured");
  EXPECT_NEAR(pierced.puncture_force_uN, 4.0, 1e-12);
  EXPECT_FALSE(mentions(pierced.doubt_list, "punctures in one contact"));
}

TEST(CellPassport, APunctureWithoutAForceJustBeforeHasNone) {
  SyntheticRows rows;
  rows.approach();
  rows.push(0.5, 20.0, linear);
  for (int i = 0; i < 30; ++i) rows.add(std::nullopt);
  rows.punctured(10, 50.0);
  const auto contact = only_contact(rows);
  EXPECT_EQ(contact.outcome, "punctured");
  EXPECT_TRUE(std::isnan(contact.puncture_force_uN) && std::isnan(contact.drop_uN));
  EXPECT_NEAR(contact.peak_force_uN, 2.0, 1e-12);
  EXPECT_TRUE(mentions(contact.doubt_list, "no force just before it"));
  EXPECT_TRUE(mentions(contact.doubt_list, "30 of 80 frames were recorded but not measured"));
}

TEST(CellPassport, AnUntouchedCellHasNoNumbers) {
  SyntheticRows rows;
  rows.approach();
  const auto cells = rows.passports();
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].contacts, 0);
  EXPECT_NEAR(cells[0].radius_um, 50.0, 1e-9);
  const ContactPassport& none = cells[0].main_contact();
  EXPECT_EQ(none.outcome, "untouched");
  for (const auto& field : contact_fields()) {
    if (const auto* member = std::get_if<double ContactPassport::*>(&field.field.member)) {
      EXPECT_TRUE(std::isnan(none.**member)) << field.field.name;
    }
  }
}

TEST(CellPassport, SpeedsAreTheTips) {
  const auto contact = only_contact(push_and_pull(40.0, linear, linear));
  EXPECT_NEAR(contact.approach_speed_um_per_s, 15.0, 1e-9);
  EXPECT_NEAR(contact.insertion_speed_um_per_s, 15.0, 1e-9);
  EXPECT_NEAR(contact.removal_speed_um_per_s, 15.0, 1e-9);
}

TEST(CellPassport, SpeedsAreAgainstACellThatDrifts) {
  SyntheticRows rows = push_and_pull(20.0, linear, linear);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows.row(i).cell_x_um += 0.1 * static_cast<double>(i);
    rows.row(i).tip_x_um += 0.1 * static_cast<double>(i);
  }
  EXPECT_NEAR(only_contact(rows).insertion_speed_um_per_s, 15.0, 1e-9);
}

TEST(CellPassport, MembraneAndDepositsComeFromTheirRows) {
  const SyntheticRows rows = push_and_pull(20.0, linear, linear);
  PassportInput input = rows.input();
  input.membrane.resize(rows.size());
  input.membrane[40] = {3.0, 0.2, 0.5};
  input.membrane[60] = {2.0, 0.3, 0.4};
  input.membrane[5] = {9.0, 9.0, 9.0};  // before the touch
  input.is_hand_recorded = true;
  input.deposits = {{0.1, 0.2}, {1.5, 1.75}, {2.0, 2.25}};
  const auto contact = cell_passports(input).at(0).contact_list.at(0);
  EXPECT_DOUBLE_EQ(contact.largest_area_strain_percent, 3.0);
  EXPECT_DOUBLE_EQ(contact.largest_mean_tension_uN_per_um, 0.3);
  EXPECT_DOUBLE_EQ(contact.largest_tension_uN_per_um, 0.5);
  EXPECT_NEAR(contact.deposit_s, 0.5, 1e-9);
  EXPECT_NEAR(contact.first_deposit_s, 1.5, 1e-9);
  // Without a hand there is nothing to say, and with one that deposited nothing there is a 0.
  input.deposits.clear();
  EXPECT_EQ(cell_passports(input).at(0).contact_list.at(0).deposit_s, 0.0);
  input.is_hand_recorded = false;
  EXPECT_TRUE(std::isnan(cell_passports(input).at(0).contact_list.at(0).deposit_s));
}

TEST(CellPassport, EachWarningIsSaidInWords) {
  for (const ForceWarning warning : {kShapeMismatch, kNeedleSlip, kNotOfRevolution, kSeldomBorne}) {
    SyntheticRows rows;
    rows.approach();
    rows.push(0.5, 10.0, linear);
    rows.event(event_kind::kWarning, to_string(warning) + ": contour 2.0 um from the model");
    rows.push(10.5, 20.0, linear);
    const auto contact = only_contact(rows);
    EXPECT_TRUE(mentions(contact.doubt_list, describe(warning, "mouse-oocyte"))) << contact.doubts;
  }
}

// The kind's spread is no fault of a recording: it widens the interval and raises no doubt.
TEST(CellPassport, OnlyWhatThePictureLeavesOpenIsADoubt) {
  const auto with = [](double picture_ratio, double scale_ratio) {
    SyntheticRows rows;
    rows.approach();
    rows.push(0.5, 20.0, linear);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Measurement& m = rows.row(i);
      m.contact_force_lower_uN = 0.3 * m.contact_force_uN;
      m.contact_force_upper_uN = 3.0 * m.contact_force_uN;
      m.contact_force_picture_lower_uN = (1.0 - 1.96 * picture_ratio) * m.contact_force_uN;
      m.contact_force_picture_upper_uN = (1.0 + 1.96 * picture_ratio) * m.contact_force_uN;
      m.contact_force_scale_lower_uN = std::exp(-1.96 * scale_ratio) * m.contact_force_uN;
      m.contact_force_scale_upper_uN = std::exp(1.96 * scale_ratio) * m.contact_force_uN;
    }
    return only_contact(rows);
  };
  const auto usual = with(0.09, 0.46), blurred = with(0.25, 0.46);
  EXPECT_NEAR(usual.picture_sigma_percent, 9.0, 1e-9);
  EXPECT_NEAR(usual.scale_sigma_percent, 46.0, 1e-9);
  EXPECT_FALSE(mentions(usual.doubt_list, "a wide interval"));
  EXPECT_TRUE(mentions(blurred.doubt_list, "shows the peak force to +- 49 % only"));
}

TEST(CellPassport, DoubtsNameWhatSpeaksAgainstTheNumbers) {
  SyntheticRows rows;
  rows.push(0.5, 20.0, linear);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows.row(i).confidence = 0.4;
    rows.row(i).contact_force_upper_uN = 2.0 * rows.row(i).contact_force_uN;
  }
  for (int i = 0; i < 3; ++i) rows.seen(CellState::kContact, -20.0, 20.0, std::nan(""));
  rows.event(event_kind::kNote, "no force: the needle was not seen");
  rows.event(event_kind::kNote, "looks fine to me");
  rows.seen(CellState::kContact, -20.0, 20.0, 2.0);
  const auto cells = rows.passports();
  const auto& doubts = cells.at(0).contact_list.at(0).doubt_list;
  EXPECT_TRUE(mentions(doubts, "first seen in contact"));
  EXPECT_TRUE(mentions(doubts, "low confidence: 40 %"));
  EXPECT_TRUE(mentions(doubts, "shows the peak force to +- 55 % only"));
  EXPECT_TRUE(mentions(doubts, "3 frames in contact have no force"));
  EXPECT_TRUE(mentions(doubts, "no force: the needle was not seen"));
  EXPECT_TRUE(mentions(doubts, "ends in contact"));
  EXPECT_FALSE(mentions(doubts, "looks fine"));
  EXPECT_TRUE(mentions(cells.at(0).notes, "looks fine to me"));
}

TEST(CellPassport, OfSeveralPuncturesTheFirstCountsAndThereIsADoubt) {
  SyntheticRows rows;
  for (const double depth_um : {30.0, 40.0}) {
    rows.approach();
    rows.push(0.5, depth_um, linear);
    rows.punctured(10, depth_um + 5.0);
  }
  rows.approach(2);
  const auto cells = rows.passports();
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_NEAR(cells[0].main_contact().puncture_force_uN, 3.0, 1e-12);
  EXPECT_TRUE(mentions(cells[0].doubt_list, "punctured in 2 contacts"));
}

}  // namespace
}  // namespace pellucida
