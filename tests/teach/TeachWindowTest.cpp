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
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

#include "CellPage.h"
#include "ReadoutPage.h"
#include "SnakePage.h"
#include "Theme.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionWriter.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/visualization_vtk/MessageLog.h"
#include "ui/DisplayTest.h"
#include "ui/XInput.h"
#include "widgets/LessonPanel.h"
#include "widgets/ParameterPanel.h"
#include "widgets/ParameterSlider.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

using test::XInput;
constexpr std::uint32_t kPageDownKey = 0xff56, kPageUpKey = 0xff55, kLeftKey = 0xff51;

class TeachWindowTest : public test::DisplayTest {
 protected:
  TeachWindowTest() : log_(MessageLog::install()), problems_(log_->problem_count()) {}
  ~TeachWindowTest() override { EXPECT_EQ(log_->problem_count(), problems_) << log_->last_problem(); }

  // At the lesson named, shown and active, its first drawings done.
  void open(const std::string& lesson) {
    window_ = std::make_unique<TeachWindow>(choose_lessons(lesson), TeachOptions{});
    window_->QWidget::show();
    window_->activateWindow();
    ASSERT_TRUE(pass_until([&] { return qApp->applicationState() == Qt::ApplicationActive; })) << "not active";
    if (window_->cell().view_widget().isVisible()) {
      ASSERT_TRUE(pass_until([&] { return newest() && newest()->run > 0 && newest()->time_s > 0.05; }));
    }
    pass(300);
  }

  CellSnapshotPtr newest() { return window_->cell().runner().newest(); }

  QPoint on_screen(const Eigen::Vector2d& device_px) {
    ViewWidget& widget = window_->cell().view_widget();
    const double ratio = widget.devicePixelRatioF();
    return widget.mapToGlobal(
        QPoint(qRound(device_px.x() / ratio), widget.height() - 1 - qRound(device_px.y() / ratio)));
  }

  // The node on the near side that is furthest on screen from all others: a click on it can mean no other.
  int node_by_itself() {
    const PokedCellView& view = window_->cell().view();
    const int count = static_cast<int>(newest()->x_um.cols());
    int best = 0;
    double furthest_px = 0.0;
    for (int node = 0; node < count; ++node) {
      const Eigen::Vector2d at_px = view.node_on_screen_px(node);
      if (view.node_at(at_px.x(), at_px.y()) != node) continue;
      double nearest_px = 1e9;
      for (int other = 0; other < count; ++other)
        if (other != node) nearest_px = std::min(nearest_px, (view.node_on_screen_px(other) - at_px).norm());
      if (nearest_px > furthest_px) best = node;
      furthest_px = std::max(furthest_px, nearest_px);
    }
    return best;
  }

  // The one that is seen, where pages have widgets of the same name.
  template <class Widget>
  Widget& child(const char* name) {
    const auto all = window_->findChildren<Widget*>(name);
    EXPECT_FALSE(all.isEmpty()) << name;
    for (Widget* one : all)
      if (one->isVisible()) return *one;
    return *all.front();
  }

  MessageLog* log_;
  std::uint64_t problems_;
  XInput input_;
  std::unique_ptr<TeachWindow> window_;
};

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
  auto& table = child<QTableWidget>("nodeForces");
  ASSERT_TRUE(pass_until([&] { return table.isVisible() && !table.item(0, 1)->text().isEmpty(); }));
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

// The lesson on snakes as its "do" has it: step by step, to rest, too stiff, and from another circle.
TEST_F(TeachWindowTest, ASnakeIsSteppedRunAndPlacedByMouse) {
  open("what-a-snake-does");
  SnakePage& page = window_->snake();
  ASSERT_TRUE(pass_until([&] { return page.picture() && page.picture()->field; }));
  EXPECT_TRUE(pass_until([&] { return child<QLabel>("snakeStep").text() == "0"; }));
  input_.tap(0x73);  // s
  ASSERT_TRUE(pass_until([&] { return page.snake().iteration() == 1; }));
  EXPECT_FALSE(page.is_running());
  EXPECT_TRUE(pass_until([&] { return child<QLabel>("snakeStep").text() == "1"; }));
  const double before = page.snake().energy().total();
  page.slider(SnakeSlider::kPace).slider().setValue(1000);
  input_.tap(0x72);  // r
  ASSERT_TRUE(pass_until([&] { return page.snake().state() == SnakeState::kConverged; }));
  EXPECT_TRUE(pass_until([&] { return !page.is_running(); }));
  EXPECT_LT(page.snake().energy().total(), before - 100.0);
  EXPECT_EQ(static_cast<int>(page.chart_data().curve.size()), page.snake().iteration() + 1);
  keep_picture(*window_, "teach-snake");
  // Stiffer: it is no longer at rest where it is; from the beginning it cuts the dimple.
  page.slider(SnakeSlider::kBeta).slider().setValue(
      static_cast<int>(1000 * snake_scale(SnakeSlider::kBeta).place_of(300.0)));
  EXPECT_EQ(page.snake().state(), SnakeState::kMoving);
  input_.tap(test::kHomeKey);
  ASSERT_TRUE(pass_until([&] { return page.snake().iteration() == 0; }));
  child<QToolButton>("runSnake").click();
  ASSERT_TRUE(pass_until([&] { return page.snake().state() == SnakeState::kConverged; }));
  EXPECT_GT(page.snake().energy().bending, 100.0);
  keep_picture(*window_, "teach-snake-stiff");

  // Its middle moves the circle, its rim changes its size.
  const auto on_page = [&](const Eigen::Vector2d& place_um) {
    ViewWidget& widget = page.view_widget();
    const Eigen::Vector2d at_px = page.view().place_on_screen_px(place_um) / widget.devicePixelRatioF();
    return widget.mapToGlobal(QPoint(qRound(at_px.x()), widget.height() - 1 - qRound(at_px.y())));
  };
  const auto drag = [&](const Eigen::Vector2d& from_um, const Eigen::Vector2d& to_um) {
    const QPoint from = on_page(from_um), to = on_page(to_um);
    input_.move(from.x(), from.y());
    pass(50);
    input_.left_button(true);
    pass(50);
    input_.move(to.x(), to.y());
    pass(50);
    input_.left_button(false);
    pass(50);
  };
  const SnakeSetting setting = page.setting();
  const Eigen::Vector2d middle_um(setting.start_x_um, setting.start_y_um);
  drag(middle_um, middle_um + Eigen::Vector2d(8.0, -5.0));
  EXPECT_TRUE(pass_until([&] { return std::abs(page.setting().start_x_um - setting.start_x_um - 8.0) < 1.0; }));
  EXPECT_NEAR(page.setting().start_y_um, setting.start_y_um - 5.0, 1.0);
  EXPECT_EQ(page.snake().iteration(), 0);
  const Eigen::Vector2d moved_um(page.setting().start_x_um, page.setting().start_y_um);
  drag(moved_um + Eigen::Vector2d(setting.start_radius_um, 0.0), moved_um + Eigen::Vector2d(50.0, 0.0));
  EXPECT_TRUE(pass_until([&] { return std::abs(page.setting().start_radius_um - 50.0) < 1.0; }));
  EXPECT_NEAR(page.setting().start_x_um, moved_um.x(), 1e-9);
}

TEST_F(TeachWindowTest, ASnakeSeesARecordedFrame) {
  open("what-a-snake-does");
  SnakePage& page = window_->snake();
  ASSERT_TRUE(pass_until([&] { return page.picture() && page.picture()->field; }));
  page.ask_recording = [] { return std::filesystem::path("no-such-session"); };
  QComboBox& choice = child<QComboBox>("pictureChoice");
  const auto choose_last = [&] {
    choice.setCurrentIndex(choice.count() - 1);
    emit choice.activated(choice.count() - 1);
  };
  choose_last();
  ASSERT_TRUE(pass_until([&] { return !page.picture()->fault.empty(); }));
  EXPECT_TRUE(pass_until([&] { return child<QLabel>("pictureFault").text().contains("no-such-session"); }));
  EXPECT_FALSE(page.snake().state() == SnakeState::kConverged);
  // A film is read as a session is: by any source's name.
  const auto film = std::filesystem::path(testing::TempDir()) / "snake-film";
  std::filesystem::remove_all(film);
  const auto microscope = open_virtual("default");
  SessionWriter writer(film, SessionInfo{.source = microscope->info()});
  const auto frame = microscope->next();
  Scene scene;
  scene.frame = frame->image;
  scene.measurement.frame = 0;
  writer.write(scene);
  writer.close();
  page.ask_recording = [&] { return film; };
  choose_last();
  ASSERT_TRUE(pass_until([&] { return page.picture()->fault.empty() && page.picture()->order.source == film.string(); }));
  EXPECT_NEAR(page.picture()->pixel_size_um, 0.825, 1e-9);
}

TEST_F(TeachWindowTest, AContourIsReadInTwoWays) {
  open("prescribed-contour");
  ReadoutPage& page = window_->readouts();
  ASSERT_TRUE(pass_until([&] { return page.shown() && page.chart_data().curve.size() > 20; }));
  EXPECT_TRUE(pass_until([&] { return child<QLabel>("trueForce").text() == "2.02 µN"; }));
  EXPECT_EQ(child<QLabel>("equilibriumForce").text(), "1.97 µN");
  EXPECT_EQ(child<QLabel>("prescribedForce").text(), "0.29 µN");
  EXPECT_EQ(child<QLabel>("prescribedForceNote").text(), "-86 %");
  pass(200);
  keep_picture(*window_, "teach-readouts");
  // Deeper, the force that is read falls below nothing.
  page.slider(ReadoutSlider::kDepth).slider().setValue(1000);
  ASSERT_TRUE(pass_until([&] { return page.shown()->parameters.depth_um == 44.0; }));
  EXPECT_LT(page.shown()->prescribed.force_uN, 0.0);
  pass(200);
  keep_picture(*window_, "teach-readouts-deep");
  // Another draw of noise is another force.
  page.slider(ReadoutSlider::kNoise).slider().setValue(300);
  ASSERT_TRUE(pass_until([&] { return page.shown()->parameters.noise_um > 0.29; }));
  const double drawn_uN = page.shown()->prescribed.force_uN;
  input_.tap(0x6e);  // n
  ASSERT_TRUE(pass_until([&] { return page.shown()->parameters.draw == 2.0; }));
  EXPECT_NE(page.shown()->prescribed.force_uN, drawn_uN);
  // Where each piece really is.
  QComboBox& laying = child<QComboBox>("layingChoice");
  laying.setCurrentIndex(laying.findData("true-places"));
  emit laying.activated(laying.currentIndex());
  ASSERT_TRUE(pass_until([&] { return page.shown()->parameters.laying == "true-places"; }));
  EXPECT_GT(page.shown()->prescribed.force_uN, 3.0);
  input_.tap(test::kHomeKey);
  EXPECT_TRUE(pass_until([&] { return page.shown()->parameters.depth_um == 20.0; }));
}

TEST_F(TeachWindowTest, KeysTurnToEachPage) {
  open("volume");
  const double time_s = newest()->time_s;
  input_.tap(0xffc0);  // F3
  ASSERT_TRUE(pass_until([&] { return child<QWidget>("snake").isVisible(); }));
  // A page that is not shown does nothing.
  pass(200);
  const double paused_s = newest()->time_s;
  EXPECT_GE(paused_s, time_s);
  pass(300);
  EXPECT_EQ(newest()->time_s, paused_s);
  ASSERT_TRUE(pass_until([&] { return window_->snake().picture() && window_->snake().picture()->field; }))
      << "a page that is opened by hand is set up too";
  input_.tap(0xffc1);  // F4
  ASSERT_TRUE(pass_until([&] { return window_->readouts().shown() != nullptr; }));
  input_.tap(0xffbf);  // F2
  ASSERT_TRUE(pass_until([&] { return newest()->time_s > paused_s; }));
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
