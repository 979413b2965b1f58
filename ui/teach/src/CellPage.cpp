#include "CellPage.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <limits>

#include "Words.h"
#include "pellucida/teaching_vtk/PokeStyle.h"
#include "presenters/TeachPresenter.h"
#include "widgets/ButtonKey.h"
#include "widgets/FigureBar.h"
#include "widgets/KeySheet.h"
#include "widgets/NodeForceTable.h"
#include "widgets/Panel.h"
#include "widgets/ParameterPanel.h"
#include "widgets/SidePage.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr double kSlowPeriod_s = 0.1;
constexpr double kWithdrawn_um = -10.0;
constexpr double kHandRest_s = 0.15;
constexpr std::size_t kForceFigure = 1;

/// The node nearest to the needle's tip.
int node_under_tip(const CellSnapshot& s) {
  const Eigen::Vector3d tip_um = s.mesh->mid_radius_um * Eigen::Vector3d::UnitZ() + s.tip_um;
  Eigen::Index nearest = 0;
  (s.x_um.colwise() - tip_um).colwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

}  // namespace

CellPage::CellPage(const TeachingParameters& first)
    : runner_(first),
      curve_stage_(
          curve_step_, curve_orders_, [this](QuasiStaticCurvePtr curve) { curves_.publish(std::move(curve)); }, clock_,
          [this](const TeachingParameters& parameters, const StepFailure& failure) {
            curves_.publish(std::make_shared<QuasiStaticCurve>(QuasiStaticCurve{parameters, {}, {}, failure.reason}));
          }) {
  curve_stage_.start();
}

CellPage::~CellPage() {
  curve_stage_.stop();
}

QWidget* CellPage::make_figures() {
  figures_ = new FigureBar(words("In contact"),
                           {{"depth", words("DEPTH"), "-00.0 µm", {}, true},
                            {"force", words("FORCE"), "00.00 µN", words("at rest: 00.00 µN"), true},
                            {"volume", words("VOLUME"), "-00.00 %", {}, false},
                            {"energy", words("ENERGY"), words("0.000 pJ"), {}, false},
                            {"speed", words("FASTEST NODE"), "00000 µm/s", {}, false},
                            {"rate", words("STEPS, PACE"), "00000 /s, 0.00×", {}, true}},
                           nullptr);
  return figures_;
}

QWidget* CellPage::make_stage() {
  QWidget* cell = make_cell();
  return view_over_chart(cell, make_chart());
}

QWidget* CellPage::make_cell() {
  cell_widget_ = new ViewWidget(cell_view_, 0, nullptr);
  cell_widget_->setObjectName("cell");
  cell_widget_->setAccessibleName(words("Cell"));
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
  QObject::connect(panel->add_toggle(words("Springs"), words("Connectors, coloured by their pull"), Qt::Key_1, true),
                   &QToolButton::toggled, panel, [this](bool on) { cell_view_.show_springs(on); });
  QObject::connect(panel->add_toggle(words("Surface"), words("The membrane"), Qt::Key_2, true), &QToolButton::toggled,
                   panel, [this](bool on) { cell_view_.show_surface(on); });
  QObject::connect(panel->add_button(words("Reset"), tip_with_key(words("Back to the first point of view"), Qt::Key_V)),
                   &QToolButton::clicked, panel, [this] { cell_view_.reset_camera(); });
  return panel;
}

QWidget* CellPage::make_chart() {
  constexpr int kSamples = 4;
  chart_widget_ = new ViewWidget(chart_, kSamples, nullptr);
  chart_widget_->setAccessibleName(words("Force over depth"));
  chart_.set_reference(words("quasi-static"), {}, {});
  return new pellucida::Panel(words("Force over depth"), chart_widget_, nullptr);
}

QWidget* CellPage::make_side() {
  side_ = make_side_tabs();
  parameter_panel_ = new ParameterPanel([this](const TeachingParameters& p) { change(p); }, nullptr);
  side_->addTab(scrolled(parameter_panel_), words("Parameters"));
  force_table_ = new NodeForceTable(nullptr);
  QObject::connect(&force_table_->head_to_tail(), &QCheckBox::toggled, side_,
                   [this](bool on) { cell_view_.set_head_to_tail(on); });
  side_->addTab(scrolled(force_table_), words("Node forces"));
  return side_;
}

void CellPage::set_shown(bool shown) {
  // Opened by hand, without a lesson of its own.
  if (shown && !curve_orders_.peek()) begin(Lesson{});
  runner_.set_paused(!shown);
}

void CellPage::set_type_scale(double scale) {
  for (ViewWidget* widget : {cell_widget_, chart_widget_}) {
    widget->set_type_scale(scale);
    widget->render();
  }
}

void CellPage::withdraw() {
  move_hand(kWithdrawn_um, 0.0);
}

// As on screen: the needle comes from the right.
void CellPage::nudge(double right_um, double up_um) {
  move_hand(hand_along_um_ - right_um, hand_across_um_ + up_um);
}

void CellPage::begin(const Lesson& lesson) {
  parameter_panel_->set_parameters(lesson.setting);
  change(lesson.setting);
  runner_.explain(std::nullopt);
  explains_tip_ = lesson.explains_tip;
  force_table_->show_hint();
  side_->setCurrentIndex(lesson.explains_tip ? 1 : 0);
  move_hand(lesson.hand_depth_um, 0.0);
  restart();
}

void CellPage::change(const TeachingParameters& parameters) {
  runner_.set_parameters(parameters);
  const auto ordered = curve_orders_.peek();
  if (!ordered || !have_same_curve(*ordered, parameters)) curve_orders_.publish(parameters);
}

void CellPage::restart() {
  runner_.restart();
}

void CellPage::move_hand(double along_um, double across_um) {
  // The cell holds it within reach; what it made of it is taken over once the hand rests.
  hand_moved_s_ = clock_.now_s();
  hand_along_um_ = along_um;
  hand_across_um_ = across_um;
  runner_.set_hand(along_um, across_um);
}

void CellPage::pick(int x_px, int y_px) {
  const auto node = cell_view_.node_at(x_px, y_px);
  runner_.explain(node);
  explains_tip_ = false;
  if (!node) force_table_->show_hint();
  if (node) side_->setCurrentIndex(1);
}

void CellPage::tick() {
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
}

void CellPage::show_newest() {
  const auto newest = runner_.newest();
  if (!newest) return;
  show(newest);
  show_slowly(*newest);
}

void CellPage::show(const CellSnapshotPtr& snapshot) {
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
void CellPage::show_curve(const CellSnapshot& s) {
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
void CellPage::show_slowly(const CellSnapshot& s) {
  const auto curve = curves_.peek().value_or(nullptr);
  const bool fits = curve && have_same_curve(curve->parameters, s.parameters) && s.depth_um > 0.0;
  const double rest_uN =
      fits ? force_at_uN(curve->depth_um, curve->force_uN, s.depth_um) : std::numeric_limits<double>::quiet_NaN();
  const TeachTexts texts = teach_texts(s, rest_uN, current_theme());
  figures_->show_state(texts.state);
  figures_->show_figures({texts.depth, texts.force, texts.volume, texts.energy, texts.speed, texts.rate});
  figures_->show_note(kForceFigure, texts.force_note);
  banner_text_->setText(QString::fromStdString(texts.blow_up));
  banner_->setVisible(!texts.blow_up.empty());
  parameter_panel_->show_limits(s);
  if (s.node_forces) force_table_->show_forces(*s.node_forces, current_theme());
}

}  // namespace pellucida
