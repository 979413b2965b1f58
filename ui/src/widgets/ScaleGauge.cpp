#include "widgets/ScaleGauge.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

constexpr double kWidest = 4.0;  // times the kind's stiffness
constexpr int kWidth_px = 130, kHeight_px = 34;
constexpr double kBarTop_px = 4.0, kBarHeight_px = 12.0;

QColor gauge_color(const Color& color) {
  return QColor::fromRgbF(color.red, color.green, color.blue);
}

}  // namespace

ScaleGauge::ScaleGauge(QWidget* parent) : QWidget(parent) {
  setObjectName("scaleGauge");
  setMaximumWidth(kWidth_px);
  setFixedHeight(kHeight_px);
}

QSize ScaleGauge::sizeHint() const {
  return {kWidth_px, kHeight_px};
}

void ScaleGauge::show_scale(const ScaleTexts& texts) {
  const bool same = texts.ratio == texts_.ratio && texts.sigma == texts_.sigma && texts.is_own == texts_.is_own &&
                    texts.kind_sigma == texts_.kind_sigma;
  texts_ = texts;
  setToolTip(QString::fromStdString(texts.tip));
  if (!same) update();
}

void ScaleGauge::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double margin = 10.0;
  const auto x_of = [&](double log_ratio) {
    const double share = 0.5 + 0.5 * log_ratio / std::log(kWidest);
    return margin + std::clamp(share, 0.0, 1.0) * (width() - 2.0 * margin);
  };
  const auto band = [&](double log_ratio, double sigma, double inset_px, const Color& color) {
    const double from = x_of(log_ratio - sigma), to = std::max(from + 3.0, x_of(log_ratio + sigma));
    painter.setPen(Qt::NoPen);
    painter.setBrush(gauge_color(color));
    painter.drawRoundedRect(QRectF(from, kBarTop_px + inset_px, to - from, kBarHeight_px - 2.0 * inset_px), 2.0, 2.0);
  };
  band(0.0, std::log(kWidest), 4.5, current_theme().border);
  band(0.0, texts_.kind_sigma, 1.5, current_theme().curve_before);
  if (texts_.is_own) band(std::log(texts_.ratio), texts_.sigma, 0.0, current_theme().accent);

  // Ticks at a quarter, one and four.
  QFont font = this->font();
  font.setPixelSize(10);
  painter.setFont(font);
  painter.setPen(gauge_color(current_theme().text_dim));
  for (const auto& [ratio, text] : {std::pair{1.0 / kWidest, "¼"}, std::pair{1.0, "1"}, std::pair{kWidest, "4"}}) {
    const double x = x_of(std::log(ratio));
    painter.drawLine(QPointF(x, kBarTop_px + kBarHeight_px), QPointF(x, kBarTop_px + kBarHeight_px + 3.0));
    painter.drawText(QRectF(x - 20.0, kBarTop_px + kBarHeight_px + 3.0, 40.0, 13.0), Qt::AlignCenter,
                     QString::fromUtf8(text));
  }
}

}  // namespace pellucida
