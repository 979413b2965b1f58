#include "ReviewViews.h"

#include <QMouseEvent>
#include <cmath>

#include "Words.h"
#include "presenters/SessionCurves.h"
#include "presenters/SourcePresenter.h"
#include "widgets/CurvePanel.h"
#include "widgets/FeedPanel.h"
#include "widgets/MembranePanel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

// A press that moves further turns the view instead.
constexpr int kClick_px = 4;

QSplitter* pair_of(QWidget* left, QWidget* right) {
  auto* pair = new QSplitter(Qt::Horizontal);
  pair->setHandleWidth(4);
  pair->setChildrenCollapsible(false);
  pair->addWidget(left);
  pair->addWidget(right);
  pair->setStretchFactor(0, 1);
  pair->setStretchFactor(1, 1);
  pair->setSizes({10000, 10000});
  return pair;
}

void name_curves(const SessionComparison& comparison, CurveChartData& data) {
  data.curve_name = session_name_of(comparison.shown().folder);
  data.other_name = session_name_of(comparison.other().folder);
  data.inner = {};  // one band for each
}

}  // namespace

ReviewViews::ReviewViews(std::function<void(double)> seek, std::function<void(long)> pick, QWidget* parent)
    : QSplitter(Qt::Vertical, parent), pick_(std::move(pick)) {
  build(std::move(seek));
}

// The widgets show the views: they go first.
ReviewViews::~ReviewViews() {
  while (count() > 0) delete widget(0);
}

void ReviewViews::build(std::function<void(double)> seek) {
  feed_.set_empty_text(words("No image of this frame"));
  membranes_.set_empty_text(words("No surface of this frame"));
  setHandleWidth(4);
  setChildrenCollapsible(false);
  feed_panel_ = new FeedPanel(feed_, nullptr, false);
  membrane_panel_ = new MembranePanel(membranes_, nullptr, false);
  touch_ = new CurvePanel(words("Force over indentation"), {}, nullptr);
  time_ = new CurvePanel(words("Force over time"), std::move(seek), nullptr);
  QSplitter* views = pair_of(feed_panel_, membrane_panel_);
  QSplitter* charts = pair_of(touch_, time_);
  // The upright borders are aligned, and stay so.
  connect(views, &QSplitter::splitterMoved, charts, [=] { charts->setSizes(views->sizes()); });
  connect(charts, &QSplitter::splitterMoved, views, [=] { views->setSizes(charts->sizes()); });
  addWidget(views);
  addWidget(charts);
  setStretchFactor(0, 3);
  setStretchFactor(1, 1);
  setSizes({520, 230});
  membrane_panel_->view().installEventFilter(this);
  // What is dropped on a view is for the window.
  for (ViewWidget* view : {&feed_panel_->view(), &membrane_panel_->view(), &touch_->view(), &time_->view()}) {
    view->setAcceptDrops(false);
  }
}

void ReviewViews::set_session(const RecordedSession& session) {
  session_ = &session;
  touch_shown_.reset();
  feed_.set_caption(source_caption(session.info.source));
  feed_.reset_camera();
  source_->SetScene(Scene{});
  membranes_.refresh();
  comparison_ = nullptr;
  step_ = 0;
  fill_time();
  mark_node(std::nullopt);
}

void ReviewViews::compare(const SessionComparison* comparison, Alignment alignment) {
  comparison_ = comparison;
  alignment_ = alignment;
  if (!session_) return;
  fill_time();
  fill_touch(step_);
}

void ReviewViews::fill_time() {
  CurveChartData drawn = pellucida::force_over_time(*session_);
  if (comparison_) {
    drawn.other = comparison_->other_over_time(alignment_);
    name_curves(*comparison_, drawn);
  }
  time_->chart().set_data(std::move(drawn));
}

void ReviewViews::fill_touch(std::size_t step) {
  CurveChartData drawn = pellucida::force_over_indentation(*session_, step);
  if (comparison_) {
    drawn.other = comparison_->other_over_indentation(step);
    name_curves(*comparison_, drawn);
  }
  touch_->chart().set_data(std::move(drawn));
}

void ReviewViews::show_step(const Scene& scene, std::size_t step) {
  source_->SetScene(scene);
  feed_.refresh();
  membranes_.refresh();
  feed_panel_->view().render();
  membrane_panel_->view().render();
  if (!session_) return;
  step_ = step;
  const std::size_t touch = touch_of(*session_, step);
  if (touch != touch_shown_) {
    fill_touch(step);
    touch_shown_ = touch;
  }
  const Measurement& row = scene.measurement;
  time_->chart().set_cursor(session_->times_s[step], row.contact_force_uN, true);
  const bool on_curve = row.state == CellState::kContact && std::isfinite(row.contact_force_uN);
  touch_->chart().set_cursor(on_curve ? row.indentation_um : CurveChart::kNowhere, row.contact_force_uN, false);
}

void ReviewViews::draw_charts() {
  time_->render();
  touch_->render();
}

void ReviewViews::mark_node(std::optional<long> node) {
  membranes_.mark_node(node);
  membrane_panel_->view().render();
}

void ReviewViews::mark_hints(std::vector<HintMark> marks) {
  feed_.set_hints(std::move(marks));
  feed_panel_->view().render();
}

bool ReviewViews::eventFilter(QObject* target, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress) {
    const auto* mouse = static_cast<const QMouseEvent*>(event);
    pressed_px_.reset();
    if (mouse->button() == Qt::LeftButton) pressed_px_ = mouse->pos();
  } else if (event->type() == QEvent::MouseButtonRelease && pressed_px_) {
    const QPoint place_px = static_cast<const QMouseEvent*>(event)->pos();
    const bool clicked = (place_px - *pressed_px_).manhattanLength() <= kClick_px;
    pressed_px_.reset();
    const auto node = clicked ? membranes_.node_at(place_px.x(), place_px.y()) : std::nullopt;
    if (node) pick_(*node);
  }
  return QSplitter::eventFilter(target, event);
}

}  // namespace pellucida
