// The pages of Teach mode beside the poked cell: a snake, a contour read in two ways; and the way of Tab through all.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ReadoutPage.h"
#include "SnakePage.h"
#include "pellucida/session/SessionWriter.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "teach/TeachWindows.h"
#include "ui/TabStops.h"
#include "widgets/LessonPanel.h"
#include "widgets/ParameterSlider.h"

namespace pellucida {
namespace {

class TeachPagesTest : public test::TeachWindows {};

// The lesson on snakes as its "do" has it: step by step, to rest, too stiff, and from another circle.
TEST_F(TeachPagesTest, ASnakeIsSteppedRunAndPlacedByMouse) {
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
  page.slider(SnakeSlider::kBeta)
      .slider()
      .setValue(static_cast<int>(1000 * snake_scale(SnakeSlider::kBeta).place_of(300.0)));
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

TEST_F(TeachPagesTest, ASnakeSeesARecordedFrame) {
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
  ASSERT_TRUE(
      pass_until([&] { return page.picture()->fault.empty() && page.picture()->order.source == film.string(); }));
  EXPECT_NEAR(page.picture()->pixel_size_um, 0.825, 1e-9);
}

TEST_F(TeachPagesTest, AContourIsReadInTwoWays) {
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

TEST_F(TeachPagesTest, KeysTurnToEachPage) {
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

// On each page: every control by Tab, named for a screen reader, the bar before the lessons before what is shown before
// its controls.
TEST_F(TeachPagesTest, TabComesToEveryControlInOrderAndEachHasAName) {
  open("volume");
  for (const std::uint32_t page_key : {0xffbfu, 0xffc0u, 0xffc1u}) {
    input_.tap(page_key);
    pass(500);
    const auto stops = test::tab_stops(*window_);
    ASSERT_GT(stops.size(), 15u);
    for (QWidget* missed : test::controls_without_stop(*window_, stops))
      ADD_FAILURE() << "Tab passes by " << test::widget_text(*missed);
    for (QWidget* stop : stops) EXPECT_NE(test::spoken_name(*stop), "") << test::widget_text(*stop);
    // Parts of the window in the order of the stops, from the bar on.
    const QWidget* parts[] = {&child<QWidget>("topBar"), &window_->lessons(), child<QTabBar>("pages").parentWidget(),
                              &child<QWidget>("sideStack")};
    const auto part_of = [&](const QWidget* widget) {
      for (int k = 0; k < 4; ++k)
        if (parts[k]->isAncestorOf(widget)) return k;
      return -1;
    };
    const auto first = std::find_if(stops.begin(), stops.end(), [&](const QWidget* w) { return part_of(w) == 0; });
    ASSERT_NE(first, stops.end());
    auto from_bar = stops;
    std::rotate(from_bar.begin(), from_bar.begin() + (first - stops.begin()), from_bar.end());
    // Should the walk have begun within the bar, its first buttons come last.
    while (part_of(from_bar.back()) == 0) std::rotate(from_bar.begin(), from_bar.end() - 1, from_bar.end());
    int part = 0;
    for (const QWidget* stop : from_bar) {
      EXPECT_GE(part_of(stop), part) << test::widget_text(*stop);
      part = std::max(part, part_of(stop));
    }
    EXPECT_EQ(part, 3);
  }
}

}  // namespace
}  // namespace pellucida
