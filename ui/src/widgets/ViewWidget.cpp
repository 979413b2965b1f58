#include "widgets/ViewWidget.h"

#include <QVTKInteractor.h>
#include <QVTKInteractorAdapter.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorObserver.h>

#include <QApplication>
#include <QEvent>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <deque>

#include "Theme.h"
#include "Words.h"
#include "pellucida/visualization_vtk/View.h"
#include "widgets/ViewCanvas.h"

namespace pellucida {

/// The views that wait for their rendering: one an event, so that mouse and keys get their turn in between.
class ViewTurns {
 public:
  static ViewTurns& all() {
    static ViewTurns turns;
    return turns;
  }
  void add(ViewWidget& view) {
    waiting_.push_back(&view);
    if (!goes_on_) go_on();
  }
  void remove(ViewWidget& view) {
    waiting_.erase(std::remove(waiting_.begin(), waiting_.end(), &view), waiting_.end());
  }

 private:
  void go_on() {
    goes_on_ = true;
    QTimer::singleShot(0, qApp, [this] {
      if (!waiting_.empty()) waiting_.front()->render_now();
      goes_on_ = false;
      if (!waiting_.empty()) go_on();
    });
  }

  std::deque<ViewWidget*> waiting_;
  bool goes_on_ = false;
};

ViewWidget::ViewWidget(View& view, int samples, QWidget* parent)
    : QWidget(parent),
      view_(view),
      canvas_(std::make_unique<ViewCanvas>(samples)),
      gestures_(std::make_unique<QVTKInteractorAdapter>()) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 120);
  view.add_to(canvas_->window(), {}, devicePixelRatioF());
  canvas_->window()->SetInteractor(interactor_);
  interactor_->SetRenderWindow(canvas_->window());
  interactor_->Initialize();
  // What the mouse changes is rendered in its turn.
  interactor_->EnableRenderOff();
  vtkNew<vtkCallbackCommand> wish;
  wish->SetClientData(this);
  wish->SetCallback([](vtkObject*, unsigned long, void* self, void*) { static_cast<ViewWidget*>(self)->render(); });
  interactor_->AddObserver(vtkCommand::RenderEvent, wish);
  set_style(nullptr);
}

ViewWidget::~ViewWidget() {
  ViewTurns::all().remove(*this);
  interactor_->SetRenderWindow(nullptr);
}

std::vector<ViewWidget*> ViewWidget::all_in(const QWidget& window) {
  std::vector<ViewWidget*> all;
  for (QWidget* one : window.findChildren<QWidget*>()) {
    if (auto* view = dynamic_cast<ViewWidget*>(one)) all.push_back(view);
  }
  return all;
}

vtkRenderWindowInteractor* ViewWidget::interactor() const {
  return interactor_;
}

void ViewWidget::set_style(vtkInteractorObserver* style) {
  interactor_->SetInteractorStyle(style);
}

void ViewWidget::set_type_scale(double scale) {
  type_scale_ = scale;
  follow_screen();
}

void ViewWidget::follow_screen() {
  view_.set_hud_ratio(type_scale_ * devicePixelRatioF());
  const QSize size_px = size_in_pixels();
  interactor_->UpdateSize(size_px.width(), size_px.height());
  gestures_->SetDevicePixelRatio(static_cast<float>(devicePixelRatioF()), interactor_);
}

QSize ViewWidget::size_in_pixels() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize();
}

void ViewWidget::render() {
  if (waits_ || !isVisible()) return;
  waits_ = true;
  ViewTurns::all().add(*this);
}

void ViewWidget::render_now() {
  if (waits_) ViewTurns::all().remove(*this);
  waits_ = false;
  picture_ = canvas_->render(size_in_pixels());
  picture_.setDevicePixelRatio(devicePixelRatioF());
  update();
}

QImage ViewWidget::picture() {
  render_now();
  QImage picture = picture_;
  picture.setDevicePixelRatio(1.0);
  return picture;
}

QImage ViewWidget::picture(QSize size_px) {
  const QSize shown_px = size_in_pixels();
  if (size_px.isEmpty() || shown_px.isEmpty()) return picture();
  const double scale = std::min(static_cast<double>(size_px.width()) / shown_px.width(),
                                static_cast<double>(size_px.height()) / shown_px.height());
  view_.set_hud_ratio(type_scale_ * devicePixelRatioF() * scale);
  const QImage picture = canvas_->render(size_px);
  canvas_->window()->SetSize(shown_px.width(), shown_px.height());
  follow_screen();
  render();
  return picture;
}

void ViewWidget::paintEvent(QPaintEvent*) {
  // Exposed, or pictured with its window: as the view is now.
  if (waits_ || picture_.size() != size_in_pixels()) render_now();
  QPainter painter(this);
  if (!picture_.isNull()) {
    painter.drawImage(rect(), picture_);
    return;
  }
  painter.fillRect(rect(), to_qt(current_theme().view_bottom));
  painter.setPen(to_qt(current_theme().text));
  painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                   words("This needs OpenGL 3.2: install a driver of the graphics card, or Mesa"));
}

void ViewWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::StyleChange) return;
  view_.follow_theme();
  render();
}

bool ViewWidget::event(QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::ScreenChangeInternal) {
    follow_screen();
    render();
  }
  const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
  if (!key) gestures_->ProcessEvent(event, interactor_);
  return QWidget::event(event);
}

}  // namespace pellucida
