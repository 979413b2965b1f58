#include "TeachWindow.h"

#include <QApplication>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "Theme.h"
#include "Words.h"
#include "pellucida/teaching_vtk/PokeStyle.h"
#include "presenters/TeachPresenter.h"
#include "widgets/ButtonKey.h"
#include "widgets/Icons.h"
#include "widgets/LessonPanel.h"
#include "widgets/NodeForceTable.h"
#include "widgets/Panel.h"
#include "widgets/ParameterPanel.h"
#include "widgets/TeachReadouts.h"
#include "widgets/TitleBar.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr int kTeachTick_ms = 33;
constexpr double kSlowPeriod_s = 0.1;
constexpr double kLargeLetters = 1.35;
constexpr double kWithdrawn_um = -10.0;
constexpr double kHandRest_s = 0.15;
constexpr double kKeyStep_um = 1.0;
constexpr int kSideWidth_px = 330;

/// The node nearest to the needle's tip.
int node_under_tip(const CellSnapshot& s) {
  const Eigen::Vector3d tip_um = s.mesh->mid_radius_um * Eigen::Vector3d::UnitZ() + s.tip_um;
  Eigen::Index nearest = 0;
  (s.x_um.colwise() - tip_um).colwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

}  // namespace

LessonChoice choose_lessons(const std::string& name) {
  // The folder of the language's own.
  LessonChoice choice{all_lessons(say("lessons")), 0};
  if (name.empty()) return choice;
  const Lesson wanted = load_lesson(name);
  const auto same = std::find_if(choice.lessons.begin(), choice.lessons.end(),
                                 [&](const Lesson& lesson) { return lesson.name == name; });
  choice.first = static_cast<int>(same - choice.lessons.begin());
  if (same == choice.lessons.end()) choice.lessons.push_back(wanted);
  return choice;
}

TeachWindow::TeachWindow(LessonChoice lessons, TeachOptions options)
    : options_(std::move(options)),
      runner_(lessons.lessons.at(static_cast<std::size_t>(lessons.first)).setting),
      curve_stage_(
          curve_step_, curve_orders_, [this](QuasiStaticCurvePtr curve) { curves_.publish(std::move(curve)); }, clock_,
          [this](const TeachingParameters& parameters, const StepFailure& failure) {
            curves_.publish(std::make_shared<QuasiStaticCurve>(QuasiStaticCurve{parameters, {}, {}, failure.reason}));
          }) {
  curve_stage_.start();
  const int first = lessons.first;
  build(lessons);
  apply_look();
  lesson_panel_->open(first);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  timer_.start(0);
  screenshot_ = std::make_unique<TimedScreenshot>(*this, options_, [this] {
    if (const auto newest = runner_.newest()) {
      show(newest);
      show_slowly(*newest);
    }
  });
}

TeachWindow::~TeachWindow() {
  timer_.stop();
  curve_stage_.stop();
  // The widgets show the views: they go first.
  delete takeCentralWidget();
}

void TeachWindow::build(LessonChoice& lessons) {
  setWindowTitle(words("Pellucida, teach"));
  setWindowIcon(make_icon(Pictogram::kProgram));
  resize(options_.width_px, options_.height_px);
  setMinimumSize(1000, 640);

  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(build_top_bar());
  column->addWidget(readouts_ = new TeachReadouts(page));
  column->addSpacing(4);

  lesson_panel_ = new LessonPanel(
      std::move(lessons.lessons), [this](const Lesson& lesson) { begin(lesson); }, nullptr);
  auto* middle = new QSplitter(Qt::Vertical);
  middle->setHandleWidth(4);
  middle->setChildrenCollapsible(false);
  middle->addWidget(build_cell());
  middle->addWidget(build_chart());
  middle->setStretchFactor(0, 2);
  middle->setStretchFactor(1, 1);
  middle->setSizes({520, 240});
  auto* all = new QSplitter(Qt::Horizontal);
  all->setHandleWidth(4);
  all->setChildrenCollapsible(false);
  all->addWidget(new pellucida::Panel(words("Lessons"), lesson_panel_, nullptr));
  all->addWidget(middle);
  all->addWidget(build_side());
  all->setStretchFactor(1, 1);
  const int lesson_px = std::min(kSideWidth_px, options_.width_px / 4);
  const int side_px = std::min(kSideWidth_px + 30, 3 * options_.width_px / 10);
  all->setSizes({lesson_px, options_.width_px - lesson_px - side_px, side_px});
  column->addWidget(all, 1);
  setCentralWidget(page);
  add_keys();
}

QWidget* TeachWindow::build_top_bar() {
  auto* bar = new TitleBar(nullptr);
  bar->add_start_button();
  bar->add_button(words("Start again"), Qt::Key_Home, words("The cell at rest"), [this] { restart(); })
      ->setObjectName("restart");
  bar->add_button(words("Withdraw"), Qt::Key_W, words("The needle out of the cell"),
                  [this] { move_hand(kWithdrawn_um, 0.0); });
  const auto add_look = [&](const QString& text, Qt::Key key, const QString& tip, bool& option) {
    auto* button = bar->add_button(text, key, tip, [this, &option] {
      option = !option;
      apply_look();
    });
    button->setCheckable(true);
    button->setChecked(option);
  };
  add_look(words("Large letters"), Qt::Key_T, words("For the last row"), options_.large_letters);
  bar->add_button(words("Full screen"), Qt::Key_F11, words("All of the screen, and back"),
                  [this] { isFullScreen() ? showNormal() : showFullScreen(); });
  bar->add_look_menu(Qt::Key_L);
  bar->add_name(words("Teach"), words("A simulated cell to poke"), true);
  return bar;
}

QWidget* TeachWindow::build_cell() {
  cell_widget_ = new ViewWidget(cell_view_, 0, nullptr);
  cell_widget_->setObjectName("cell");
  vtkNew<PokeStyle> style;
  style->dragged = [this](int dx_px, int dy_px) {
    const Eigen::Vector2d way_um = cell_view_.hand_motion_um(dx_px, dy_px);
    move_hand(hand_along_um_ + way_um.x(), hand_across_um_ + way_um.y());
  };
  style->clicked = [this](int x_px, int y_px) { pick(x_px, y_px); };
  cell_widget_->set_style(style);

  // What ended a motion, above the cell.
  banner_ = new QWidget;
  banner_->setObjectName("banner");
  banner_->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(banner_);
  row->setContentsMargins(14, 8, 14, 8);
  banner_text_ = new QLabel(banner_);
  banner_text_->setObjectName("bannerText");
  banner_text_->setWordWrap(true);
  row->addWidget(banner_text_, 1);
  banner_->hide();
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(banner_);
  column->addWidget(cell_widget_, 1);

  auto* panel = new pellucida::Panel(words("Cell"), content, nullptr);
  connect(panel->add_toggle(words("Springs"), words("Connectors, coloured by their pull"), Qt::Key_1, true),
          &QToolButton::toggled, this, [this](bool on) { cell_view_.show_springs(on); });
  connect(panel->add_toggle(words("Surface"), words("The membrane"), Qt::Key_2, true), &QToolButton::toggled, this,
          [this](bool on) { cell_view_.show_surface(on); });
  connect(panel->add_button(words("Reset"), words("Back to the first point of view"), Qt::Key_V), &QToolButton::clicked,
          this, [this] { cell_view_.reset_camera(); });
  return panel;
}

QWidget* TeachWindow::build_chart() {
  constexpr int kSamples = 4;
  chart_widget_ = new ViewWidget(chart_, kSamples, nullptr);
  chart_.set_reference(words("quasi-static"), {}, {});
  return new pellucida::Panel(words("Force over depth"), chart_widget_, nullptr);
}

QWidget* TeachWindow::build_side() {
  side_ = new QTabWidget;
  side_->setDocumentMode(true);
  side_->tabBar()->setDrawBase(false);
  side_->setUsesScrollButtons(false);
  parameter_panel_ = new ParameterPanel([this](const TeachingParameters& p) { change(p); }, nullptr);
  const auto add_page = [this](QWidget* page, const QString& name) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    side_->addTab(scroll, name);
  };
  add_page(parameter_panel_, words("Parameters"));
  force_table_ = new NodeForceTable(nullptr);
  connect(&force_table_->head_to_tail(), &QCheckBox::toggled, this,
          [this](bool on) { cell_view_.set_head_to_tail(on); });
  add_page(force_table_, words("Node forces"));
  return side_;
}

void TeachWindow::add_keys() {
  const auto key = [this](const QKeySequence& keys, const QString& meaning, std::function<void()> act) {
    add_window_key(*this, keys, meaning, std::move(act));
  };
  key(QKeySequence::Quit, words("Close the window"), [this] { close(); });
  key(Qt::Key_PageDown, words("Next lesson"), [this] { lesson_panel_->open(lesson_panel_->current() + 1); });
  key(Qt::Key_PageUp, words("Lesson before"), [this] { lesson_panel_->open(lesson_panel_->current() - 1); });
  // As on screen: the needle comes from the right.
  key(QKeySequence("Shift+Left"), words("Needle forwards by 1 µm"),
      [this] { move_hand(hand_along_um_ + kKeyStep_um, hand_across_um_); });
  key(QKeySequence("Shift+Right"), words("Needle back by 1 µm"),
      [this] { move_hand(hand_along_um_ - kKeyStep_um, hand_across_um_); });
  key(QKeySequence("Shift+Up"), words("Needle up by 1 µm"),
      [this] { move_hand(hand_along_um_, hand_across_um_ + kKeyStep_um); });
  key(QKeySequence("Shift+Down"), words("Needle down by 1 µm"),
      [this] { move_hand(hand_along_um_, hand_across_um_ - kKeyStep_um); });
}

void TeachWindow::apply_look() {
  const double letters = options_.large_letters ? kLargeLetters : 1.0;
  apply_theme(*qApp, current_theme(), letters);
  cell_widget_->set_type_scale(letters);
  chart_widget_->set_type_scale(letters);
  cell_widget_->render();
  chart_widget_->render();
}

void TeachWindow::begin(const Lesson& lesson) {
  parameter_panel_->set_parameters(lesson.setting);
  change(lesson.setting);
  runner_.explain(std::nullopt);
  explains_tip_ = lesson.explains_tip;
  force_table_->show_hint();
  side_->setCurrentIndex(lesson.explains_tip ? 1 : 0);
  move_hand(lesson.hand_depth_um, 0.0);
  restart();
}

void TeachWindow::change(const TeachingParameters& parameters) {
  runner_.set_parameters(parameters);
  const auto ordered = curve_orders_.peek();
  if (!ordered || !have_same_curve(*ordered, parameters)) curve_orders_.publish(parameters);
}

void TeachWindow::restart() {
  runner_.restart();
}

void TeachWindow::move_hand(double along_um, double across_um) {
  // The cell holds it within reach; what it made of it is taken over once the hand rests.
  hand_moved_s_ = clock_.now_s();
  hand_along_um_ = along_um;
  hand_across_um_ = across_um;
  runner_.set_hand(along_um, across_um);
}

void TeachWindow::pick(int x_px, int y_px) {
  const auto node = cell_view_.node_at(x_px, y_px);
  runner_.explain(node);
  explains_tip_ = false;
  if (!node) force_table_->show_hint();
  if (node) side_->setCurrentIndex(1);
}

void TeachWindow::tick() {
  QElapsedTimer spent;
  spent.start();
  runner_.rethrow();
  curve_stage_.rethrow();
  // The first drawings take long: the lesson's push begins once it can be seen.
  if (unseen_ticks_ > 0 && --unseen_ticks_ == 0) restart();
  if (const auto sequence = runner_.sequence(); sequence != shown_sequence_) {
    shown_sequence_ = sequence;
    show(runner_.newest());
  } else {
    cell_widget_->render();
  }
  // Also once the motion has ended and no new snapshot comes.
  if (const auto newest = runner_.newest(); newest && clock_.now_s() - slow_shown_s_ >= kSlowPeriod_s) {
    slow_shown_s_ = clock_.now_s();
    show_slowly(*newest);
  }
  // A slow renderer must leave time for the mouse and the other threads.
  const int spent_ms = static_cast<int>(spent.elapsed());
  timer_.start(std::max(kTeachTick_ms - spent_ms, spent_ms / 3));
}

void TeachWindow::show(const CellSnapshotPtr& snapshot) {
  const CellSnapshot& s = *snapshot;
  show_curve(s);
  for (const CurvePoint& point : runner_.take_curve()) {
    if (point.run != shown_run_) chart_.clear();
    shown_run_ = point.run;
    chart_.append(chart_row(point, row_index_++));
  }
  if (explains_tip_) {
    runner_.explain(node_under_tip(s));
    explains_tip_ = false;
  }
  if (clock_.now_s() - hand_moved_s_ > kHandRest_s) {
    hand_along_um_ = s.hand_along_um;
    hand_across_um_ = s.hand_across_um;
  }
  cell_view_.set_snapshot(snapshot);
  cell_widget_->render();
  chart_widget_->render();
}

// The curve of the cell as it is; another cell's would be wrong.
void TeachWindow::show_curve(const CellSnapshot& s) {
  QuasiStaticCurvePtr fitting = curves_.peek().value_or(nullptr);
  if (fitting && !have_same_curve(fitting->parameters, s.parameters)) fitting.reset();
  if (fitting == shown_curve_) return;
  shown_curve_ = fitting;
  if (!fitting) {
    chart_.set_reference(words("quasi-static: is computed"), {}, {});
  } else {
    chart_.set_reference(fitting->fault.empty() ? std::string(words("quasi-static"))
                                                : std::string(words("quasi-static: ")) + say_message(fitting->fault),
                         fitting->depth_um, fitting->force_uN);
  }
}

// Writing changes ten times a second: faster nobody reads.
void TeachWindow::show_slowly(const CellSnapshot& s) {
  const auto curve = curves_.peek().value_or(nullptr);
  const bool fits = curve && have_same_curve(curve->parameters, s.parameters) && s.depth_um > 0.0;
  const double rest_uN =
      fits ? force_at_uN(curve->depth_um, curve->force_uN, s.depth_um) : std::numeric_limits<double>::quiet_NaN();
  const TeachTexts texts = teach_texts(s, rest_uN, current_theme());
  readouts_->show_texts(texts);
  banner_text_->setText(QString::fromStdString(texts.blow_up));
  banner_->setVisible(!texts.blow_up.empty());
  parameter_panel_->show_limits(s);
  if (s.node_forces) force_table_->show_forces(*s.node_forces, current_theme());
}

}  // namespace pellucida
