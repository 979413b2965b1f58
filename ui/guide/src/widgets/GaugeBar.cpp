#include "widgets/GaugeBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "Theme.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

constexpr int kBarHeight_px = 14, kBarGap_px = 4;
// Largest letters of the number, and the bar's height that leaves them whole. Digits of 40 px letters are 29 px
// high: 7.7 mm on a screen of 96 px an inch, 13 minutes of arc at two metres, where sharp eyes need 5.
constexpr int kLetters_px = 40, kLowLetters_px = 32, kSmallestLetters_px = 22;
constexpr int kHeight_px = 122, kLowHeight_px = 110;

Color level_color(GaugeLevel level) {
  const ThemeColors& theme = current_theme();
  switch (level) {
    case GaugeLevel::kOver:
    case GaugeLevel::kNone:
      return theme.record;
    case GaugeLevel::kNear:
    case GaugeLevel::kDoubt:
      return theme.warning;
    case GaugeLevel::kCalm:
      break;
  }
  return theme.accent;
}

QColor faded(const Color& color, double opacity) {
  QColor faded = to_qt(color);
  faded.setAlphaF(opacity);
  return faded;
}

void set_text(QLabel& label, const std::string& text) {
  label.setText(QString::fromStdString(text));
}

}  // namespace

GaugeBox::GaugeBox(QWidget* parent) : QFrame(parent) {
  setObjectName("gaugeBox");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 3, 10, 3);
  column->setSpacing(0);
  const auto label = [this](const char* style) {
    auto* text = new QLabel(this);
    text->setProperty(style, true);
    text->setTextFormat(Qt::PlainText);
    // Texts are cut off at the box rather than widening it.
    text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    return text;
  };
  auto* head = new QHBoxLayout;
  head->setSpacing(8);
  head->addWidget(name_ = label("gaugeName"));
  head->addWidget(alarm_ = label("gaugeAlarm"));
  name_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  alarm_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
  head->addStretch(1);
  head->addWidget(truth_ = label("gaugeTruth"));
  truth_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
  column->addLayout(head);
  column->addWidget(value_ = label("gaugeValue"), 1);
  column->addSpacing(kBarHeight_px + 2 * kBarGap_px);
  auto* foot = new QHBoxLayout;
  foot->setSpacing(8);
  foot->addWidget(note_ = label("gaugeNote"), 1);
  foot->addWidget(limit_ = label("gaugeNote"));
  limit_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  limit_->setAlignment(Qt::AlignRight);
  column->addLayout(foot);
}

void GaugeBox::show_gauge(const Gauge& gauge) {
  if (gauge == gauge_) return;
  gauge_ = gauge;
  value_->setObjectName(QString::fromStdString(gauge.key));
  note_->setObjectName(QString::fromStdString(gauge.key + "Note"));
  alarm_->setObjectName(QString::fromStdString(gauge.key + "Alarm"));
  set_text(*name_, gauge.name);
  set_text(*value_, gauge.value);
  set_text(*note_, gauge.note);
  set_text(*limit_, gauge.limit);
  set_text(*alarm_, gauge.alarm);
  truth_->setObjectName(QString::fromStdString(gauge.key + "Truth"));
  set_text(*truth_, gauge.truth);
  truth_->setVisible(!gauge.truth.empty());
  alarm_->setVisible(!gauge.alarm.empty());
  const ThemeColors& theme = current_theme();
  set_sheet(*alarm_,
            QString::fromStdString("background: " + level_color(gauge.level).css() + "; color: " + theme.window.css()));
  setToolTip(QString::fromStdString(gauge.tip));
  setAccessibleName(QString::fromStdString(gauge.name + " " + gauge.value + " " + gauge.note + " " + gauge.alarm));
  fit_number();
  // A limit's longer name takes its room at once.
  layout()->activate();
  update();
}

void GaugeBox::set_letters(int largest_px) {
  letters_px_ = largest_px;
  fit_number();
}

void GaugeBox::resizeEvent(QResizeEvent*) {
  fit_number();
}

// As large as the box lets it be, in steps, so that running digits don't make it jump.
void GaugeBox::fit_number() {
  constexpr int kStep_px = 4;
  const int room_px = width() - 20;
  // The number's width with every digit as wide as the widest.
  QString widest = value_->text();
  for (QChar& letter : widest) {
    if (letter.isDigit()) letter = '0';
  }
  int size_px = letters_px_;
  QFont letters = font();
  letters.setBold(true);
  for (; size_px > kSmallestLetters_px; size_px -= kStep_px) {
    letters.setPixelSize(size_px);
    if (QFontMetrics(letters).horizontalAdvance(widest) <= room_px) break;
  }
  set_sheet(*value_, QString("font-size: %1px").arg(size_px));
}

void GaugeBox::paintEvent(QPaintEvent*) {
  const ThemeColors& theme = current_theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Color color = level_color(gauge_.level);
  const bool is_calm = gauge_.level == GaugeLevel::kCalm;
  const QRectF box = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
  painter.setPen(is_calm ? QPen(to_qt(theme.border), 1.0) : QPen(to_qt(color), 2.0));
  painter.setBrush(is_calm ? QColor(Qt::transparent) : faded(color, 0.16));
  painter.drawRoundedRect(box, 7.0, 7.0);

  // The bar.
  const double left = 10.0, length = width() - 20.0, top = note_->y() - kBarGap_px - kBarHeight_px;
  const auto x_at = [&](double share) { return left + length * std::clamp(share, 0.0, 1.0); };
  QPainterPath track;
  track.addRoundedRect(QRectF(left, top, length, kBarHeight_px), 3.0, 3.0);
  painter.setPen(Qt::NoPen);
  painter.fillPath(track, faded(theme.border, std::isfinite(gauge_.limit_share) ? 1.0 : 0.4));
  painter.setClipPath(track);
  const auto band = [&](double from, double to, double inset_px, const QColor& fill) {
    if (!std::isfinite(from) || !std::isfinite(to)) return;
    const double width_px = std::max(2.0, x_at(to) - x_at(from));
    painter.fillRect(QRectF(x_at(from), top + inset_px, width_px, kBarHeight_px - 2.0 * inset_px), fill);
  };
  if (std::isfinite(gauge_.share)) band(0.0, gauge_.share, 4.0, to_qt(color));
  band(gauge_.from, gauge_.to, 0.0, faded(color, 0.30));
  band(gauge_.inner_from, gauge_.inner_to, 0.0, faded(color, 0.35));
  if (std::isfinite(gauge_.share) && !gauge_.value.empty()) {
    painter.fillRect(QRectF(x_at(gauge_.share) - 2.0, top, 4.0, kBarHeight_px), to_qt(theme.text));
  }
  painter.setClipping(false);
  // What lies beyond the limit is hatched; its mark stands out over the bar.
  if (std::isfinite(gauge_.limit_share)) {
    const double x = x_at(gauge_.limit_share);
    painter.setClipPath(track);
    painter.fillRect(QRectF(x, top, left + length - x, kBarHeight_px),
                     QBrush(faded(theme.text, 0.35), Qt::BDiagPattern));
    painter.setClipping(false);
    painter.fillRect(QRectF(x - 1.5, top - 4.0, 3.0, kBarHeight_px + 8.0), to_qt(theme.text));
  }
  // The truth: a wedge from above.
  if (std::isfinite(gauge_.truth_share)) {
    const double x = x_at(gauge_.truth_share);
    painter.setPen(Qt::NoPen);
    painter.setBrush(to_qt(theme.good));
    painter.drawPolygon(QPolygonF({{x - 5.0, top - 4.0}, {x + 5.0, top - 4.0}, {x, top + 6.0}}));
  }
  if (std::isfinite(gauge_.usual_share)) {
    painter.fillRect(QRectF(x_at(gauge_.usual_share) - 0.5, top - 2.0, 1.5, kBarHeight_px + 4.0),
                     to_qt(theme.text_dim));
  }
}

GaugeBar::GaugeBar(QWidget* parent) : QFrame(parent) {
  setObjectName("gaugeBar");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 4, 12, 4);
  row->setSpacing(8);
  for (GaugeBox*& box : boxes_) {
    box = new GaugeBox(this);
    row->addWidget(box, 1);
  }
  set_low(false);
}

void GaugeBar::set_low(bool low) {
  setFixedHeight(low ? kLowHeight_px : kHeight_px);
  for (GaugeBox* box : boxes_) box->set_letters(low ? kLowLetters_px : kLetters_px);
}

void GaugeBar::show_gauges(const std::array<Gauge, 4>& gauges) {
  gauges_ = gauges;
  for (std::size_t k = 0; k < boxes_.size(); ++k) boxes_[k]->show_gauge(gauges[k]);
}

}  // namespace pellucida
