#include "ContactLogic.h"

#include <gtest/gtest.h>

#include <random>

namespace pellucida {
namespace {

ContactLogic fresh() {
  ContactLogic logic{TrackerOptions{}};
  logic.reset(CellState::kFree);
  return logic;
}

TEST(ContactLogic, NoiseOfAQuarterPixelRaisesNoAlarm) {
  ContactLogic logic = fresh();
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.25);
  for (int k = 0; k < 10000; ++k)
    EXPECT_EQ(logic.update({1.0 + noise(random), noise(random), true}), CellState::kFree) << "frame " << k;
}

TEST(ContactLogic, OneFrameOfTheMembraneAloneDoesNotDecide) {
  ContactLogic logic = fresh();
  EXPECT_EQ(logic.update({0.5, 5.0, true}), CellState::kFree);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(logic.update({0.0, 0.0, true}), CellState::kFree);
  EXPECT_EQ(logic.update({0.5, 5.0, true}), CellState::kFree);
  EXPECT_EQ(logic.update({0.5, 5.0, true}), CellState::kContact);
}

TEST(ContactLogic, TipAndMembranePastTheRestingOutlineDecideAtOnceWhereBothAreSure) {
  const auto state = [](double sigma_px, double tip_sigma_px) {
    return fresh().update(
        {.tip_px = 3.0, .membrane_px = 3.0, .needle_seen = true, .sigma_px = sigma_px, .tip_sigma_px = tip_sigma_px});
  };
  EXPECT_EQ(state(0.25, 0.25), CellState::kContact);
  EXPECT_EQ(state(0.25, 1.5), CellState::kFree);
  EXPECT_EQ(state(0.8, 0.25), CellState::kFree);
}

TEST(ContactLogic, PressingHoldingAndDrawingBackIsNoPuncture) {
  ContactLogic logic = fresh();
  for (double depth = 0.0; depth < 50.0; depth += 0.5) logic.update({depth, depth, true});
  EXPECT_EQ(logic.state(), CellState::kContact);
  for (double depth = 50.0; depth > -3.0; depth -= 1.0) {
    logic.update({depth, std::max(0.0, depth), true});
    EXPECT_NE(logic.state(), CellState::kPunctured);
  }
  EXPECT_EQ(logic.state(), CellState::kFree);
}

TEST(ContactLogic, MembraneLeavingTheTipIsAPunctureUntilTheTipIsOut) {
  ContactLogic logic = fresh();
  for (double depth = 0.0; depth < 50.0; depth += 0.5) logic.update({depth, depth, true});
  EXPECT_EQ(logic.update({50.0, 15.0, true}), CellState::kPunctured);
  for (double depth = 50.0; depth > 0.5; depth -= 1.0)
    EXPECT_EQ(logic.update({depth, 2.0, true}), CellState::kPunctured);
  EXPECT_EQ(logic.update({-1.0, 0.0, true}), CellState::kFree);
}

TEST(ContactLogic, AMembraneLeftBehindInADimpleThatIsPushedIsNoPuncture) {
  const auto frame = [](double tip_px, double membrane_px, bool is_pushed) {
    return ContactLogic::Depths{
        .tip_px = tip_px, .membrane_px = membrane_px, .needle_seen = true, .is_pushed = is_pushed};
  };
  ContactLogic logic = fresh();
  for (double depth = 0.0; depth < 20.0; depth += 0.5) logic.update(frame(depth, depth, true));
  EXPECT_EQ(logic.update(frame(20.5, 9.0, true)), CellState::kContact);
  EXPECT_EQ(logic.update(frame(21.0, 9.0, false)), CellState::kPunctured);
  // Pushed again, in three frames: it never gave way.
  for (int k = 0; k < 2; ++k) EXPECT_EQ(logic.update(frame(21.5, 9.5, true)), CellState::kPunctured);
  EXPECT_EQ(logic.update(frame(22.0, 10.0, true)), CellState::kContact);
}

TEST(ContactLogic, ATipThatIsNotKnownTellsNoPuncture) {
  ContactLogic logic = fresh();
  for (double depth = 0.0; depth < 10.0; depth += 0.5) logic.update({depth, depth, true});
  EXPECT_EQ(logic.update({18.0, 10.0, true, 0.25, 3.0}), CellState::kContact);
  EXPECT_EQ(logic.update({18.0, 10.0, true, 0.25, 0.3}), CellState::kPunctured);
}

TEST(ContactLogic, AMembraneOnTheTipAgainHasNotGivenWay) {
  ContactLogic logic = fresh();
  for (double depth = 1.0; depth <= 30.0; depth += 1.0) logic.update({depth, depth, true, 0.25, 0.3});
  ASSERT_EQ(logic.update({30.0, 12.0, true, 0.25, 0.3}), CellState::kPunctured);
  // At rest, or on its way there, it has.
  for (const double membrane : {8.0, 4.0, 2.0, 1.0, 1.0, 1.0})
    EXPECT_EQ(logic.update({30.0, membrane, true, 0.25, 0.3}), CellState::kPunctured) << membrane;
  EXPECT_EQ(logic.update({30.0, 29.0, true, 0.25, 0.3}), CellState::kPunctured);
  EXPECT_EQ(logic.update({30.0, 29.5, true, 0.25, 0.3}), CellState::kPunctured);
  EXPECT_EQ(logic.update({30.0, 29.5, true, 0.25, 0.3}), CellState::kContact);
  // A needle drawn out of a punctured cell is not on its membrane again.
  EXPECT_EQ(logic.update({31.0, 12.0, true, 0.25, 0.3}), CellState::kPunctured);
  for (double tip = 20.0; tip > 0.0; tip -= 1.0)
    EXPECT_EQ(logic.update({tip, 1.0, true, 0.25, 0.3}), CellState::kPunctured) << tip;
  EXPECT_EQ(logic.update({-1.0, 0.0, true, 0.25, 0.3}), CellState::kFree);
}

TEST(ContactLogic, ASlowApproachIsNoticedWithinTwoPixels) {
  // 12 um/s at 30 frames a second and 0.825 um a pixel: half a pixel a frame.
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 0.15);
  for (int run = 0; run < 200; ++run) {
    ContactLogic logic = fresh();
    double depth = -3.0 + 0.01 * run;
    while (logic.update({depth + noise(random), std::max(0.0, depth) + noise(random), true, 0.15}) !=
           CellState::kContact)
      depth += 0.5;
    EXPECT_LT(depth, 2.0) << "run " << run;
    EXPECT_GT(depth, 0.0) << "run " << run;
  }
}

// A dent of one pixel can't be distinguished from none: the tip's own place decides.
TEST(ContactLogic, ATipSurelyJustPastTheMembranePushesIt) {
  const auto frame = [](double tip_px, double past_sigma_px) {
    return ContactLogic::Depths{
        .tip_px = tip_px, .membrane_px = 0.2, .needle_seen = true, .tip_sigma_px = 0.3, .past_sigma_px = past_sigma_px};
  };
  EXPECT_EQ(fresh().update(frame(0.9, 0.3)), CellState::kContact);
  EXPECT_EQ(fresh().update(frame(0.9, 0.6)), CellState::kFree) << "not sure enough";
  EXPECT_EQ(fresh().update(frame(0.9, 0.0)), CellState::kFree) << "not known";
  EXPECT_EQ(fresh().update(frame(0.4, 0.1)), CellState::kContact);
  EXPECT_EQ(fresh().update(frame(0.25, 0.1)), CellState::kFree) << "too little";
  // It stays a contact while it is so shallow; a needle above the cell goes on over an outline that stays where it was.
  ContactLogic logic = fresh();
  for (const double tip_px : {0.9, 1.1, 1.3, 1.5, 1.8})
    EXPECT_EQ(logic.update(frame(tip_px, 0.3)), CellState::kContact);
  EXPECT_EQ(logic.update(frame(2.4, 0.3)), CellState::kContact);
  for (const double tip_px : {3.0, 3.6, 4.2}) EXPECT_EQ(logic.update(frame(tip_px, 0.3)), CellState::kFree) << tip_px;
}

TEST(ContactLogic, AMembraneThatMovesFarFromTheTipIsNoContact) {
  ContactLogic logic = fresh();
  for (int k = 0; k < 20; ++k) EXPECT_EQ(logic.update({-8.0, 5.0, true}), CellState::kFree);
}

TEST(ContactLogic, WithoutANeedleNothingChanges) {
  ContactLogic logic = fresh();
  for (int k = 0; k < 10; ++k) EXPECT_EQ(logic.update({-1e3, 20.0, false}), CellState::kFree);
}

}  // namespace
}  // namespace pellucida
