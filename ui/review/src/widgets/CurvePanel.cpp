#include "widgets/CurvePanel.h"

#include <QMouseEvent>

#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr int kCurveSamples = 4;

}  // namespace

CurvePanel::CurvePanel(const QString& title, std::function<void(double)> seek, QWidget* parent)
    : CurvePanel(std::make_unique<CurveChart>(), title, parent) {
  set_seek(std::move(seek));
}

CurvePanel::CurvePanel(std::unique_ptr<CurveChart> chart, const QString& title, QWidget* parent)
    : CurvePanel(new ViewWidget(*chart, kCurveSamples, nullptr), title, parent) {
  chart_ = std::move(chart);
}

CurvePanel::CurvePanel(ViewWidget* view, const QString& title, QWidget* parent)
    : Panel(title, view, parent), view_(view) {
  view_->installEventFilter(this);
}

// The widget shows the chart: it goes first.
CurvePanel::~CurvePanel() {
  delete view_;
}

void CurvePanel::set_seek(std::function<void(double)> seek) {
  seek_ = std::move(seek);
  if (seek_) {
    view_->setCursor(Qt::PointingHandCursor);
  } else {
    view_->unsetCursor();
  }
}

void CurvePanel::render() {
  view_->render();
}

bool CurvePanel::eventFilter(QObject*, QEvent* event) {
  const bool pressed = event->type() == QEvent::MouseButtonPress;
  if (!seek_ || (!pressed && event->type() != QEvent::MouseMove)) return false;
  const auto* mouse = static_cast<const QMouseEvent*>(event);
  if (!(mouse->buttons() & Qt::LeftButton)) return false;
  if (const auto x = chart_->x_at(mouse->localPos().x())) seek_(*x);
  return true;
}

}  // namespace pellucida
