#include "widgets/TimelineBar.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "Theme.h"
#include "Words.h"
#include "pellucida/core/RoundNumbers.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr int kHeight_px = 78;
constexpr double kSide_px = 16.0;
constexpr double kLegendY_px = 11.0;
constexpr double kMarksTop_px = 20.0;
constexpr double kBarTop_px = 31.0;
constexpr double kBarHeight_px = 20.0;
constexpr double kDoubtTop_px = 53.0;
constexpr double kDoubtHeight_px = 4.0;
constexpr double kTickTop_px = 60.0;
constexpr double kTickRoom_px = 90.0;
constexpr double kReach_px = 5.0;  // of a mark

void set_small_letters(QPainter& painter) {
  QFont letters = painter.font();
  letters.setPixelSize(11);
  painter.setFont(letters);
}

// A stretch that is shorter than a pixel still shows.
QRectF stretch(double x0, double x1, double y, double height_px) {
  return {x0, y, std::max(x1 - x0, 1.0), height_px};
}

}  // namespace

TimelineBar::TimelineBar(std::function<void(double)> seek, QWidget* parent) : QWidget(parent), seek_(std::move(seek)) {
  setObjectName("timeline");
  setFixedHeight(kHeight_px);
  setMouseTracking(false);
  setCursor(Qt::PointingHandCursor);
  timeline_.end_s = 1.0;
}

void TimelineBar::set_timeline(Timeline timeline) {
  timeline_ = std::move(timeline);
  ground_ = QPixmap();
  update();
}

void TimelineBar::set_position_s(double time_s) {
  if (time_s == position_s_) return;
  position_s_ = time_s;
  update();
}

QRectF TimelineBar::bar() const {
  return {kSide_px, kBarTop_px, std::max(width() - 2.0 * kSide_px, 1.0), kBarHeight_px};
}

double TimelineBar::x_of(double time_s) const {
  const double share = (time_s - timeline_.begin_s) / (timeline_.end_s - timeline_.begin_s);
  return bar().left() + share * bar().width();
}

double TimelineBar::time_at(double x_px) const {
  const double share = std::clamp((x_px - bar().left()) / bar().width(), 0.0, 1.0);
  return timeline_.begin_s + share * (timeline_.end_s - timeline_.begin_s);
}

void TimelineBar::draw_legend(QPainter& painter) const {
  double x = kSide_px;
  const auto entry = [&](const Color& color, Qt::BrushStyle style, double height_px, const std::string& name) {
    painter.fillRect(QRectF(x, kLegendY_px - 0.5 * height_px, 10.0, height_px), QBrush(to_qt(color), style));
    x += 15.0;
    const QString text = QString::fromStdString(name);
    painter.setPen(to_qt(current_theme().text_dim));
    painter.drawText(QPointF(x, kLegendY_px + 4.0), text);
    x += painter.fontMetrics().horizontalAdvance(text) + 16.0;
  };
  for (const CellState state : states_in(timeline_)) {
    entry(state_color(state), Qt::SolidPattern, 10.0, readout::state(state));
  }
  const auto& spans = timeline_.spans;
  if (std::any_of(spans.begin(), spans.end(), [](const auto& span) { return !span.state; })) {
    entry(current_theme().text_dim, Qt::BDiagPattern, 10.0, words("Not measured"));
  }
  const auto& events = timeline_.events;
  if (std::any_of(events.begin(), events.end(), [](const auto& event) { return event.is_doubt; })) {
    entry(current_theme().warning, Qt::SolidPattern, kDoubtHeight_px, words("Doubt, low confidence"));
  }
}

void TimelineBar::draw_spans(QPainter& painter) const {
  painter.fillRect(bar(), to_qt(current_theme().window));
  for (const TimelineSpan& span : timeline_.spans) {
    const QRectF box = stretch(x_of(span.begin_s), x_of(span.end_s), kBarTop_px, kBarHeight_px);
    painter.fillRect(box, span.state ? QBrush(to_qt(state_color(span.state)))
                                     : QBrush(to_qt(current_theme().text_dim), Qt::BDiagPattern));
  }
}

void TimelineBar::draw_events(QPainter& painter) const {
  painter.setPen(Qt::NoPen);
  for (std::size_t i = 0; i < timeline_.events.size(); ++i) {
    const ReviewEvent& event = timeline_.events[i];
    const double x = x_of(event.time_s);
    const QColor color = to_qt(event_color(event));
    if (event.is_doubt) {
      painter.fillRect(stretch(x, x_of(event.end_s), kDoubtTop_px, kDoubtHeight_px), color);
    }
    if (event.kind == kDoubtKind) continue;
    painter.setBrush(color);
    painter.drawPolygon(QPolygonF({{x - 4.0, kMarksTop_px}, {x + 4.0, kMarksTop_px}, {x, kMarksTop_px + 8.0}}));
    if (event.kind == event_kind::kPuncture && !is_revoked(timeline_.events, i)) {
      painter.fillRect(QRectF(x - 1.0, kMarksTop_px, 2.0, kBarTop_px + kBarHeight_px - kMarksTop_px),
                       to_qt(current_theme().text));
    }
  }
}

void TimelineBar::draw_ticks(QPainter& painter) const {
  const double length_s = timeline_.end_s - timeline_.begin_s;
  const double step_s = nice_ceiling(length_s / std::max(bar().width() / kTickRoom_px, 1.0), 1e-9);
  for (double k = std::ceil(timeline_.begin_s / step_s - 1e-9) + 0.0; k * step_s <= timeline_.end_s + 1e-9; k += 1.0) {
    const double x = x_of(k * step_s);
    painter.fillRect(QRectF(x - 0.5, kTickTop_px - 2.0, 1.0, 4.0), to_qt(current_theme().text_dim));
    painter.setPen(to_qt(current_theme().text_dim));
    const QRectF box(x - 40.0, kTickTop_px + 2.0, 80.0, 14.0);
    painter.drawText(box.intersected(QRectF(rect())), Qt::AlignHCenter | Qt::AlignVCenter,
                     QString::fromStdString(readout::plain(k * step_s)) + " s");
  }
}

void TimelineBar::draw_cursor(QPainter& painter) const {
  const double x = x_of(position_s_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(to_qt(current_theme().window));
  painter.drawRoundedRect(QRectF(x - 3.5, kBarTop_px - 5.0, 7.0, kBarHeight_px + 10.0), 3.5, 3.5);
  painter.setBrush(to_qt(current_theme().text));
  painter.drawRoundedRect(QRectF(x - 2.0, kBarTop_px - 4.0, 4.0, kBarHeight_px + 8.0), 2.0, 2.0);
}

void TimelineBar::draw_ground() {
  const double ratio = devicePixelRatioF();
  ground_ = QPixmap(size() * ratio);
  ground_.setDevicePixelRatio(ratio);
  ground_.fill(to_qt(current_theme().panel));
  QPainter painter(&ground_);
  painter.setRenderHint(QPainter::Antialiasing);
  set_small_letters(painter);
  draw_legend(painter);
  draw_spans(painter);
  draw_events(painter);
  draw_ticks(painter);
}

void TimelineBar::paintEvent(QPaintEvent*) {
  if (ground_.isNull()) draw_ground();
  QPainter painter(this);
  painter.drawPixmap(0, 0, ground_);
  draw_cursor(painter);
}

void TimelineBar::resizeEvent(QResizeEvent*) {
  ground_ = QPixmap();
}

// The theme has changed.
void TimelineBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange) ground_ = QPixmap();
}

void TimelineBar::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) seek_(time_at(event->localPos().x()));
}

void TimelineBar::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) seek_(time_at(event->localPos().x()));
}

bool TimelineBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<const QHelpEvent*>(event);
  const double reach_s = kReach_px / bar().width() * (timeline_.end_s - timeline_.begin_s);
  const std::string tip = timeline_tip(timeline_, time_at(help->pos().x()), reach_s);
  // Text of a session is never taken for markup.
  QToolTip::showText(help->globalPos(), "<pre>" + QString::fromStdString(tip).toHtmlEscaped() + "</pre>", this);
  return true;
}

}  // namespace pellucida
