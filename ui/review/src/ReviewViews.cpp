#include "ReviewViews.h"

#include <QAction>
#include <QLabel>
#include <QLayout>
#include <QMouseEvent>
#include <QToolButton>
#include <cmath>

#include "ModelReview.h"
#include "Words.h"
#include "presenters/SessionCurves.h"
#include "presenters/SourcePresenter.h"
#include "widgets/Choice.h"
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
  build_touch();
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

void ReviewViews::build_touch() {
  touch_ = new CurvePanel("", {}, nullptr);
  shown_ = new Choice;
  shown_->setObjectName("touchChart");
  shown_->setFocusPolicy(Qt::TabFocus);
  shown_->setFixedHeight(26);
  shown_->setAccessibleName(words("What the left chart shows"));
  shown_->addItem(words("Force over indentation"));
  for (const Quantity quantity : kQuantities) {
    shown_->addItem(words("Histogram: ") + QString::fromStdString(name_of(quantity)));
  }
  connect(shown_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) {
    show_histogram(index > 0 ? std::optional(kQuantities[static_cast<std::size_t>(index - 1)]) : std::nullopt);
  });
  touch_->lead_with(shown_);
  auto* histogram = new QAction(words("Histogram"), touch_);
  histogram->setObjectName("histogram");
  histogram->setShortcut(QKeySequence("H"));
  connect(histogram, &QAction::triggered, this,
          [this] { shown_->setCurrentIndex(shown_->currentIndex() > 0 ? 0 : 1); });
  touch_->addAction(histogram);
  shown_->setToolTip(words("What the left chart shows (H: histogram and back)"));
  model_ = new ModelReview(
      [this] {
        if (session_) fill_touch(step_);
        charts_changed_ = true;
      },
      this);
  model_button_ = touch_->add_toggle(
      words("Model"), words("The model's curves: with this cell's sizes as seen, and of the profile's own cell"),
      QKeySequence("2"), true);
  model_button_->setObjectName("model");
  connect(model_button_, &QToolButton::toggled, this, [this](bool on) { model_->set_on(on); });
  facts_ = new QLabel;
  facts_->setObjectName("chartFacts");
  facts_->setTextFormat(Qt::PlainText);
  facts_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  facts_->setContentsMargins(12, 2, 12, 4);
  facts_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  facts_->hide();
  touch_->layout()->addWidget(facts_);
}

void ReviewViews::show_histogram(std::optional<Quantity> quantity) {
  histogram_ = quantity;
  shown_->setCurrentIndex(quantity ? static_cast<int>(*quantity) + 1 : 0);
  model_button_->setVisible(!quantity);
  facts_->setVisible(quantity.has_value());
  if (!session_) return;
  fill_touch(step_);
  place_touch_cursor(session_->rows[step_]);
  charts_changed_ = true;
}

Sample ReviewViews::sample() const {
  if (!histogram_ || !session_) return {};
  return is_of_nodes(*histogram_) ? sample_of(source_->GetScene().surface.shallow_copy(), *histogram_)
                                  : sample_of(*session_, *histogram_);
}

void ReviewViews::fill_histogram() {
  const Sample counted = sample();
  facts_->setText(QString::fromStdString(histogram_facts(counted)));
  facts_->setToolTip(facts_->text());
  touch_->view().setToolTip({});
  touch_->chart().set_data(histogram_chart(counted));
}

// Where the frame shown lies: on the curve, or in the histogram.
void ReviewViews::place_touch_cursor(const Measurement& row) {
  if (histogram_) {
    const double value = is_of_nodes(*histogram_) ? CurveChart::kNowhere : value_of(row, *histogram_);
    touch_->chart().set_cursor(value, CurveChart::kNowhere, true);
    return;
  }
  const bool on_curve = row.state == CellState::kContact && std::isfinite(row.contact_force_uN);
  touch_->chart().set_cursor(on_curve ? row.indentation_um : CurveChart::kNowhere, row.contact_force_uN, false);
}

void ReviewViews::set_session(const RecordedSession& session) {
  session_ = &session;
  model_->set_session(&session);
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
  if (histogram_) return fill_histogram();
  CurveChartData drawn = pellucida::force_over_indentation(*session_, step);
  if (comparison_) {
    drawn.other = comparison_->other_over_indentation(step);
    name_curves(*comparison_, drawn);
  }
  if (const TouchModel* model = model_->shown()) {
    drawn.named.insert(drawn.named.end(), model->curves.begin(), model->curves.end());
    touch_->view().setToolTip(QString::fromStdString(model->remark));
  } else {
    touch_->view().setToolTip({});
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
    model_->show_touch(touch);
    fill_touch(step);
    touch_shown_ = touch;
  }
  const Measurement& row = scene.measurement;
  time_->chart().set_cursor(session_->times_s[step], row.contact_force_uN, true);
  if (histogram_ && is_of_nodes(*histogram_)) fill_histogram();
  place_touch_cursor(row);
}

void ReviewViews::draw_charts() {
  time_->render();
  touch_->render();
  charts_changed_ = false;
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
