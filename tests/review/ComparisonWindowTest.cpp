// Two sessions compared in the real window.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>

#include "ComparisonReview.h"
#include "NodeReview.h"
#include "ReviewViews.h"
#include "review/ReviewWindowFixture.h"
#include "support/Files.h"
#include "widgets/ComparePanel.h"
#include "widgets/CurvePanel.h"
#include "widgets/MembranePanel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

using namespace test;

class ComparisonWindowTest : public ReviewWindowTest {
 protected:
  // The session at hand, and one whose touch comes four frames later.
  void compare() {
    open();
    if (!std::filesystem::exists(*folder_ / "late")) write_touch(*folder_ / "late", true, 4);
    answer_ = *folder_ / "late";
    input_.tap(kCKey);
    ASSERT_TRUE(pass_until([&] { return window_->comparison().comparison() != nullptr; })) << text("notice");
  }
  bool shows_partner(std::size_t step) {
    return pass_until([&] { return window_->comparison().shown_partner() == step; });
  }
  QComboBox& alignment() { return *window_->findChild<QComboBox*>("compareAlignment"); }
  ComparePanel& panel() { return const_cast<ComparisonReview&>(window_->comparison()).panel(); }
  ReviewViews& views() { return const_cast<ReviewViews&>(window_->views()); }
};

TEST_F(ComparisonWindowTest, TheOtherFrameFollowsTheOneShown) {
  compare();
  EXPECT_TRUE(panel().isVisible());
  input_.tap(kEndKey);
  ASSERT_TRUE(shows(kFrames - 1));
  ASSERT_TRUE(shows_partner(kFrames - 1));
  EXPECT_EQ(panel().source().GetScene().measurement.frame, kFrames - 1);
  // The same depth was reached four frames later there: not within the recording.
  alignment().setCurrentIndex(2);
  ASSERT_TRUE(pass_until([&] { return !window_->comparison().shown_partner(); }));
  input_.tap(kHomeKey);
  ASSERT_TRUE(shows(0));
  input_.key(kShiftKey, true);
  input_.tap(kRightKey);
  input_.key(kShiftKey, false);
  ASSERT_TRUE(shows(10));
  ASSERT_TRUE(shows_partner(14));
  EXPECT_NEAR(panel().source().GetScene().measurement.indentation_um, indentation_of(10), 1e-6);
}

// A node that was picked before had the room.
TEST_F(ComparisonWindowTest, AComparisonTakesTheRoomOfANode) {
  open();
  input_.tap(kEndKey);
  ASSERT_TRUE(shows(kFrames - 1));
  click(views().membranes().view(), views().membranes().view().rect().center());
  ASSERT_TRUE(pass_until([&] { return window_->node().node().has_value(); }));
  if (!std::filesystem::exists(*folder_ / "late")) write_touch(*folder_ / "late", true, 4);
  answer_ = *folder_ / "late";
  input_.tap(kCKey);
  ASSERT_TRUE(pass_until([&] { return window_->comparison().comparison() != nullptr; }));
  EXPECT_TRUE(pass_until([&] { return panel().isVisible(); }));
  EXPECT_FALSE(window_->node().node());
}

TEST_F(ComparisonWindowTest, BothCurvesAreInTheChartsAndTheirDifferenceInTheirOwn) {
  compare();
  const CurveChartData& time = views().force_over_time().chart().data();
  EXPECT_EQ(time.curve_name, "S");
  EXPECT_EQ(time.other_name, "late");
  ASSERT_GT(time.other.size(), 5U);
  alignment().setCurrentIndex(1);
  // Of one touch, as both sessions have it.
  for (const double difference_uN : panel().curve().chart().data().curve.y) EXPECT_NEAR(difference_uN, 0.0, 1e-6);
  EXPECT_GT(panel().curve().chart().data().curve.size(), 15U);
}

TEST_F(ComparisonWindowTest, ClosingLeavesTheSessionAsItWas) {
  compare();
  input_.tap(kCKey);
  ASSERT_TRUE(pass_until([&] { return !window_->comparison().active(); }));
  EXPECT_FALSE(panel().isVisible());
  EXPECT_TRUE(views().force_over_time().chart().data().other.empty());
  input_.tap(kRightKey);
  ASSERT_TRUE(shows(1));
}

TEST_F(ComparisonWindowTest, WhatCantBeOpenedIsASentence) {
  open();
  answer_ = "/no/such/folder";
  input_.tap(kCKey);
  ASSERT_TRUE(pass_until([&] { return text("notice").find("no such session folder") != std::string::npos; }))
      << text("notice");
  EXPECT_FALSE(window_->comparison().active());
  // No answer is no comparison, and the button is up again.
  answer_.clear();
  input_.tap(kCKey);
  pass(200);
  EXPECT_FALSE(window_->comparison().active());
  for (const auto* button : window_->findChildren<QAbstractButton*>()) {
    if (button->text() == "Compare") {
      EXPECT_FALSE(button->isChecked());
    }
  }
}

TEST_F(ComparisonWindowTest, AnotherSessionEndsTheComparison) {
  compare();
  window_->open(*folder_ / "late");
  ASSERT_TRUE(pass_until([&] { return text("sourceName") == "late"; }));
  EXPECT_FALSE(window_->comparison().active());
  EXPECT_FALSE(panel().isVisible());
}

TEST_F(ComparisonWindowTest, TheDifferenceIsSavedAsTableAndDrawing) {
  compare();
  for (auto* button : panel().findChildren<QAbstractButton*>()) {
    if (button->text() == "CSV") {
      answer_ = *folder_ / "difference.csv";
      button->click();
    } else if (button->text() == "SVG") {
      answer_ = *folder_ / "difference.svg";
      button->click();
    }
  }
  EXPECT_EQ(test::text_of(*folder_ / "difference.csv").rfind("time_s,force_uN", 0), 0U);
  EXPECT_NE(test::text_of(*folder_ / "difference.svg").find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
