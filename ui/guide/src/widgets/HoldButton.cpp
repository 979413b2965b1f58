#include "widgets/HoldButton.h"

#include <QPainter>
#include <algorithm>

#include "Theme.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

constexpr int kStep_ms = 40;
// A step counts no more than this however late it comes: in a window that was busy the release may be waiting already.
constexpr double kLongestStep_s = 0.1;
constexpr int kFill_px = 4;

}  // namespace

HoldButton::HoldButton(const QString& text, std::function<void()> action, QWidget* parent)
    : QPushButton(text, parent), action_(std::move(action)) {
  timer_.setInterval(kStep_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { advance(); });
  connect(this, &QPushButton::pressed, this, [this] { hold(true); });
  connect(this, &QPushButton::released, this, [this] { hold(false); });
}

void HoldButton::hold(bool held) {
  if (held == timer_.isActive()) return;
  held_s_ = 0.0;
  if (held) {
    since_.start();
    timer_.start();
  } else {
    timer_.stop();
  }
  update();
}

void HoldButton::advance() {
  held_s_ += std::min(1e-3 * static_cast<double>(since_.restart()), kLongestStep_s);
  if (held_s_ >= kHold_s) {
    hold(false);
    action_();
  }
  update();
}

void HoldButton::hideEvent(QHideEvent* event) {
  hold(false);
  QPushButton::hideEvent(event);
}

void HoldButton::paintEvent(QPaintEvent* event) {
  QPushButton::paintEvent(event);
  if (held_s_ <= 0.0) return;
  QPainter painter(this);
  const double part = std::min(1.0, held_s_ / kHold_s);
  painter.fillRect(QRectF(1.0, height() - 1.0 - kFill_px, part * (width() - 2.0), kFill_px),
                   to_qt(current_theme().accent));
}

}  // namespace pellucida
