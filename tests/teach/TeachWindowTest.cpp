// The real window of Teach mode on an X server, driven by mouse and keys.
#include "TeachWindow.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QRadioButton>
#include <QShortcut>
#include <QSlider>
#include <QTableWidget>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "CellPage.h"
#include "ReadoutPage.h"
#include "SnakePage.h"
#include "Theme.h"
#include "pellucida/core/Error.h"
#include "teach/TeachWindows.h"
#include "ui/XInput.h"
#include "widgets/LessonPanel.h"
#include "widgets/ParameterPanel.h"
#include "widgets/ParameterSlider.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

using test::XInput;
constexpr std::uint32_t kPageDownKey = 0xff56, kPageUpKey = 0xff55, kLeftKey = 0xff51;

class TeachWindowTest : public test::TeachWindows {};

TEST_F(TeachWindowTest, DraggingPokesTheCellAndItsForceRises) {
  open("volume");
  EXPECT_LT(newest()->depth_um, 0.0);
  EXPECT_EQ(child<QLabel>("statePill").text(), "Free");

  // From the tip to the left, into the cell.
  const QPoint from = on_screen(window_->cell().view().tip_on_screen_px());
  input_.move(from.x(), from.y());
  input_.left_button(true);
  pass(100);
  double before_uN = 0.0;
  for (int k = 1; k <= 3; ++k) {
    const double hand_um = newest()->hand_along_um;
    for (int move = 0; move < 6; ++move) {
      input_.move(from.x() - 30 * (k - 1) - 5 * (move + 1), from.y());
      pass(30);
    }
    ASSERT_TRUE(pass_until([&] { return newest()->hand_along_um > hand_um + 2.0; }));
  }
  ASSERT_TRUE(pass_until([&] { return newest()->depth_um > 3.0 && newest()->force_uN > 0.3; }));
  before_uN = newest()->force_uN;
  for (int move = 0; move < 8; ++move) {
    input_.move(from.x() - 90 - 10 * (move + 1), from.y());
    pass(30);
  }
  input_.left_button(false);
  ASSERT_TRUE(pass_until([&] { return newest()->force_uN > before_uN + 0.3; }));
  // The tip stays behind the hand.
  ASSERT_TRUE(pass_until([&] { return newest()->hand_along_um - newest()->depth_um > 0.5 * newest()->force_uN; }));
  EXPECT_TRUE(pass_until([&] { return child<QLabel>("statePill").text() == "In contact"; }));
  EXPECT_TRUE(child<QLabel>("force").text().endsWith("µN"));
}

TEST_F(TeachWindowTest, TheTimeStepBlowsUpIsExplainedAndStartsAgain) {
  open("time-steps");
  EXPECT_FALSE(child<QWidget>("banner").isVisible());
  ASSERT_TRUE(pass_until([&] { return newest()->depth_um > 2.0; }));
  // As a person moves it.
  QSlider& step = window_->cell().parameters().slider(TeachSlider::kTimeStep).slider();
  step.setValue(static_cast<int>(1000 * ParameterScale(TeachSlider::kTimeStep).place_of(220.0)));
  ASSERT_TRUE(pass_until([&] { return newest()->blow_up.has_value(); }));
  EXPECT_TRUE(newest()->blow_up->is_beyond_limit());
  ASSERT_TRUE(pass_until([&] { return child<QWidget>("banner").isVisible(); }));
  EXPECT_TRUE(child<QLabel>("bannerText").text().contains("above the stability limit of symplectic-euler"));

  QComboBox& integrator = child<QComboBox>("integratorChoice");
  integrator.setCurrentIndex(integrator.findData("implicit-euler"));
  emit integrator.activated(integrator.currentIndex());
  ASSERT_TRUE(pass_until([&] { return newest()->parameters.integrator == "implicit-euler"; }));
  EXPECT_TRUE(newest()->blow_up) << "nothing heals by itself";
  input_.tap(test::kHomeKey);
  ASSERT_TRUE(pass_until([&] { return !newest()->blow_up && newest()->depth_um > 2.0; }));
  EXPECT_TRUE(pass_until([&] { return !child<QWidget>("banner").isVisible(); }));
}

TEST_F(TeachWindowTest, ALessonIsCompletedWithTheKeyboard) {
  open("");
  LessonPanel& lessons = window_->lessons();
  EXPECT_EQ(lessons.current(), 0);
  input_.tap(kPageDownKey);
  ASSERT_TRUE(pass_until([&] { return lessons.current() == 1; }));
  input_.tap(kPageUpKey);
  ASSERT_TRUE(pass_until([&] { return lessons.current() == 0; }));
  input_.tap(kPageUpKey);
  pass(100);
  EXPECT_EQ(lessons.current(), 0);

  // A wrong answer is explained, the right one is remembered.
  const Lesson lesson = load_lesson("what-a-snake-does");
  int wrong = 0, right = 0;
  for (std::size_t k = 0; k < lesson.answers.size(); ++k)
    (lesson.answers[k].is_right ? right : wrong) = static_cast<int>(k);
  child<QRadioButton>(("answer" + std::to_string(wrong)).c_str()).click();
  EXPECT_FALSE(lessons.is_done(0));
  EXPECT_TRUE(child<QLabel>("wrongAnswer").text().startsWith("No. "));
  child<QRadioButton>(("answer" + std::to_string(right)).c_str()).click();
  EXPECT_TRUE(lessons.is_done(0));
  EXPECT_TRUE(child<QLabel>("rightAnswer").text().startsWith("Right. "));
}

TEST_F(TeachWindowTest, EveryLessonCanBeCompleted) {
  open("");
  LessonPanel& panel = window_->lessons();
  const auto lessons = all_lessons();
  ASSERT_GE(lessons.size(), 10u);
  for (std::size_t k = 0; k < lessons.size(); ++k) {
    const Lesson& lesson = lessons[k];
    panel.open(static_cast<int>(k));
    // What it is about is set up as the lesson says.
    ASSERT_TRUE(pass_until([&] {
      if (lesson.page == "snake") return child<QWidget>("snake").isVisible() && window_->snake().picture() != nullptr;
      if (lesson.page == "readouts") {
        const auto pair = window_->readouts().shown();
        return pair && pair->parameters.depth_um == lesson.readouts.depth_um;
      }
      const auto snapshot = newest();
      return snapshot && snapshot->parameters.integrator == lesson.setting.integrator &&
             snapshot->parameters.time_step_us == lesson.setting.time_step_us &&
             snapshot->parameters.mesh_frequency == lesson.setting.mesh_frequency &&
             snapshot->hand_along_um == lesson.hand_depth_um;
    })) << lesson.name;
    EXPECT_FALSE(panel.is_done(static_cast<int>(k))) << lesson.name;
    const auto right =
        std::find_if(lesson.answers.begin(), lesson.answers.end(), [](const auto& a) { return a.is_right; });
    child<QRadioButton>(("answer" + std::to_string(right - lesson.answers.begin())).c_str()).click();
    EXPECT_TRUE(panel.is_done(static_cast<int>(k))) << lesson.name;
  }
}

TEST_F(TeachWindowTest, AClickOnANodeShowsItsForces) {
  open("how-sure");
  ASSERT_TRUE(pass_until([&] { return newest()->depth_um > 43.9 && newest()->largest_speed_um_per_s < 0.5; }));
  const int node = node_by_itself();
  const QPoint place = on_screen(window_->cell().view().node_on_screen_px(node));
  input_.move(place.x(), place.y());
  input_.left_button(true);
  pass(50);
  input_.left_button(false);
  ASSERT_TRUE(pass_until([&] { return newest()->node_forces.has_value(); }));
  EXPECT_EQ(newest()->node_forces->node, node);
  // The page of two read-outs has a table of that name too: the one that comes into view is meant.
  ASSERT_TRUE(pass_until([&] {
    const auto& seen = child<QTableWidget>("nodeForces");
    return seen.isVisible() && !seen.item(0, 1)->text().isEmpty();
  }));
  auto& table = child<QTableWidget>("nodeForces");
  EXPECT_EQ(table.rowCount(), static_cast<int>(kForceTermCount) + 1);
  // Written ten times a second.
  EXPECT_TRUE(pass_until([&] {
    const double pressure_uN = newest()->node_forces->of(ForceTerm::kPressure).norm();
    return pressure_uN > 0.01 && std::abs(table.item(4, 4)->text().toDouble() - pressure_uN) < 1e-3;
  }));
}

TEST_F(TeachWindowTest, KeysMoveTheNeedleAndLooksChange) {
  open("volume");
  const double before_um = newest()->hand_along_um;
  input_.key(test::kShiftKey, true);
  input_.tap(kLeftKey);
  input_.key(test::kShiftKey, false);
  ASSERT_TRUE(pass_until([&] { return newest()->hand_along_um == before_um + 1.0; }));
  EXPECT_FALSE(current_theme().is_light);
  input_.tap(0x6c);  // l
  EXPECT_TRUE(pass_until([&] { return current_theme().is_light; }));
  input_.tap(0x74);  // t
  EXPECT_TRUE(pass_until([&] { return child<QLabel>("lessonTitle").fontInfo().pixelSize() > 20; }));
  input_.tap(0x6c);
  EXPECT_TRUE(pass_until([&] { return !current_theme().is_light; }));
}

TEST_F(TeachWindowTest, NoKeyIsGivenTwice) {
  open("");
  std::map<QString, int> uses;
  for (const auto* shortcut : window_->findChildren<QShortcut*>()) ++uses[shortcut->key().toString()];
  for (const auto* button : window_->findChildren<QAbstractButton*>()) ++uses[button->shortcut().toString()];
  uses.erase(QString());
  EXPECT_TRUE(uses.contains("F11"));
  for (const auto& [key, count] : uses) EXPECT_EQ(count, 1) << key.toStdString();
}

TEST_F(TeachWindowTest, AnUnknownLessonIsAnErrorThatNamesTheKnownOnes) {
  try {
    choose_lessons("algebra");
    FAIL() << "an unknown lesson was found";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("time-steps"), std::string::npos) << error.what();
  }
  EXPECT_EQ(choose_lessons("volume").first, 3);
}

}  // namespace
}  // namespace pellucida
