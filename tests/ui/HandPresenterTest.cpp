#include "presenters/HandPresenter.h"
#include "presenters/PlanEdit.h"

#include <gtest/gtest.h>

#include "pellucida/haptics/Fixtures.h"

namespace pellucida {
namespace {

HandStatus working() {
  HandStatus status;
  status.device = "Touch";
  status.max_force_N = 3.3;
  status.real_time = "normal scheduling, memory locked";
  status.tick_count = 5000;
  status.tick.hand_state = HandState::kWorking;
  status.tick.contact_state = ContactState::kContact;
  status.tick.contact_age_s = 0.042;
  status.tick.hand_force_N = {0.3, 0.0, 0.4};
  return status;
}

TEST(HandPresenter, TellsStateForceAndItsAge) {
  const HandTexts texts = hand_texts(working(), "Inserting");
  EXPECT_EQ(texts.state.text, "Engaged");
  EXPECT_EQ(texts.force.text, "0.50 N of 3.3 N");
  EXPECT_NEAR(texts.force_share, 0.5 / 3.3, 1e-9);
  EXPECT_EQ(texts.contact.text, "Contact, 42 ms old");
  EXPECT_EQ(texts.note.text, "Inserting");
  EXPECT_FALSE(texts.stopped);
  EXPECT_NE(texts.loop.text.find("Touch"), std::string::npos);
  EXPECT_NE(texts.loop.text.find("5000 ticks"), std::string::npos);
}

TEST(HandPresenter, ADeviceWithoutForceSaysSo) {
  HandStatus status = working();
  status.max_force_N = 0.0;
  const HandTexts texts = hand_texts(status);
  EXPECT_EQ(texts.force.text, "No force feedback");
  EXPECT_EQ(texts.force_share, 0.0);
}

TEST(HandPresenter, BeforeTheFirstTickThereAreDashes) {
  HandStatus status;
  status.device = "Demonstration";
  const HandTexts texts = hand_texts(status, "Waiting for an untouched cell");
  EXPECT_EQ(texts.state.text, "Waiting");
  EXPECT_EQ(texts.force.text, "\u2013");
  EXPECT_EQ(texts.contact.text, "\u2013");
  EXPECT_EQ(texts.note.text, "Waiting for an untouched cell");
  EXPECT_EQ(texts.loop.text, "Demonstration");
}

TEST(HandPresenter, AForceThatIsTooOldOrMissingIsAWarning) {
  HandStatus status = working();
  status.tick.contact_state = ContactState::kStale;
  status.tick.limits = limit_bit(LimitKind::kContactStale);
  HandTexts texts = hand_texts(status);
  EXPECT_EQ(texts.contact.text, "Force too old: released");
  EXPECT_EQ(texts.contact.color.css(), palette::kWarning.css());
  EXPECT_EQ(texts.note.text, "") << "said once";
  status.tick.contact_state = ContactState::kInvalid;
  texts = hand_texts(status);
  EXPECT_EQ(texts.contact.text, "No force measured: released");
  EXPECT_EQ(texts.contact.color.css(), palette::kWarning.css());
}

TEST(HandPresenter, WhatIsLostSaysWhatToDo) {
  HandStatus status = working();
  status.tick.hand_state = HandState::kHeld;
  status.tick.limits = limit_bit(LimitKind::kHandLost);
  HandTexts texts = hand_texts(status, "Inserting");
  EXPECT_EQ(texts.state.text, "Held");
  EXPECT_EQ(texts.note.text, "Device lost, pipette held: plug it in or choose another hand");
  EXPECT_EQ(texts.note.color.css(), palette::kRecord.css());
  status.tick.limits = limit_bit(LimitKind::kPipetteLost);
  EXPECT_EQ(hand_texts(status).note.text, "Manipulator lost: check its cable and power");
  // The manipulator's own reason is better still.
  status.fault = "manipulator /dev/ttyUSB0: no answer";
  EXPECT_EQ(hand_texts(status).note.text, "manipulator /dev/ttyUSB0: no answer");
}

TEST(HandPresenter, TheEmergencyStopIsSaidBeforeAnyLimit) {
  HandStatus status = working();
  status.tick.hand_state = HandState::kStopped;
  status.tick.limits = limit_bit(LimitKind::kEmergencyStop) | limit_bit(LimitKind::kDepth);
  const HandTexts texts = hand_texts(status);
  EXPECT_TRUE(texts.stopped);
  EXPECT_EQ(texts.state.text, "Stopped");
  EXPECT_EQ(texts.state.color.css(), palette::kRecord.css());
  EXPECT_TRUE(texts.note.text.starts_with("Emergency stop")) << texts.note.text;
}

TEST(HandPresenter, LimitsAreNamedTheGravestFirst) {
  HandStatus status = working();
  status.tick.limits = limit_bit(LimitKind::kSpeed) | limit_bit(LimitKind::kForce);
  status.tick.fixtures = kStopBit;
  const HandTexts texts = hand_texts(status, "Inserting");
  EXPECT_EQ(texts.note.text, "Limit: depth stop, force on the cell at its limit, speed limit of the pipette");
  EXPECT_EQ(texts.note.color.css(), palette::kWarning.css());
}

TEST(HandPresenter, EveryLimitThatHoldsThePersonUpHasWords) {
  for (unsigned k = 0; k < static_cast<unsigned>(LimitKind::kCount); ++k) {
    const auto kind = static_cast<LimitKind>(k);
    // These are shown by the contact or the pill, or act for some milliseconds only.
    if (kind == LimitKind::kPuncture || kind == LimitKind::kContactStale || kind == LimitKind::kContactInvalid ||
        kind == LimitKind::kHandSlope || kind == LimitKind::kEmergencyStop) {
      continue;
    }
    HandStatus status = working();
    status.tick.limits = limit_bit(kind);
    EXPECT_NE(hand_texts(status).note.text, "") << to_string(kind);
  }
}

TEST(HandPresenter, AGuideThatActsIsNotALimit) {
  HandStatus status = working();
  status.tick.fixtures = kGuideBit;
  EXPECT_EQ(hand_texts(status, "Inserting").note.text, "Inserting, guided");
  EXPECT_EQ(hand_texts(status).note.text, "Guided");
  EXPECT_EQ(hand_texts(status).note.color.css(), palette::kPlan.css());
}

TEST(HandPresenter, ThePlansMarksLieOnItsLine) {
  InjectionPlan plan;
  plan.entry_um = {100.0, 50.0, 0.0};
  plan.axis = {-1.0, 0.0, 0.0};
  plan.approach_um = {130.0, 50.0, 0.0};
  plan.target_um = {60.0, 50.0, 0.0};
  plan.options.path_radius_um = 1.5;
  const PlanMarks marks = plan_marks(plan, 46.0, false);
  EXPECT_EQ(marks.approach_um, Eigen::Vector2d(130.0, 50.0));
  EXPECT_EQ(marks.entry_um, Eigen::Vector2d(100.0, 50.0));
  EXPECT_EQ(marks.depth_stop_um, Eigen::Vector2d(54.0, 50.0));
  EXPECT_EQ(marks.target_um, Eigen::Vector2d(60.0, 50.0));
  EXPECT_EQ(marks.corridor_um, 1.5);
  EXPECT_FALSE(marks.guided);
}

}  // namespace
}  // namespace pellucida
