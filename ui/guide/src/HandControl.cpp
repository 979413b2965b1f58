#include "HandControl.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <QWindow>
#include <cmath>

#include "StopListener.h"
#include "Words.h"
#include "pellucida/core/Error.h"
#include "presenters/HandPresenter.h"
#include "widgets/HandBar.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr Qt::Key kInjectKey = Qt::Key_D;
constexpr Qt::Key kRetractKey = Qt::Key_X;
constexpr double kNotch = 120.0;  // of the wheel, in eighths of a degree

QStringList to_list(const std::vector<std::string>& names) {
  QStringList list;
  for (const std::string& name : names) list << QString::fromStdString(name);
  return list;
}

}  // namespace

HandControl::HandControl(OperatorConsole& console, ViewWidget& feed_widget, QWidget& window)
    : console_(console), feed_widget_(feed_widget), window_(window), bar_(make_bar()) {
  qApp->installEventFilter(this);
  listen_for_stop();
}

HandControl::~HandControl() = default;

QList<QKeySequence> HandControl::keys() {
  return {QKeySequence(Qt::Key_Escape), QKeySequence("Shift+Esc"), QKeySequence(kInjectKey), QKeySequence(kRetractKey)};
}

void HandControl::listen_for_stop() {
  if (QGuiApplication::platformName() != "xcb") {
    bar_->explain_late_stop(words("the window is not drawn by an X server"));
    return;
  }
  listener_ = std::make_unique<StopListener>([this] { console_.emergency_stop(); });
  if (!listener_->trouble().empty()) bar_->explain_late_stop(listener_->trouble());
  const auto set_active = [this](Qt::ApplicationState state) { listener_->set_active(state == Qt::ApplicationActive); };
  connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, set_active);
  set_active(QGuiApplication::applicationState());
}

void HandControl::place_stop_button() {
  if (!listener_ || !window_.windowHandle()) return;
  const QWidget& button = bar_->stop_button();
  const double ratio = window_.devicePixelRatioF();
  const QPoint corner = button.mapTo(&window_, QPoint(0, 0));
  const auto pixels = [ratio](int length) { return static_cast<int>(std::lround(ratio * length)); };
  listener_->set_button({static_cast<std::uint32_t>(window_.windowHandle()->winId()), pixels(corner.x()),
                         pixels(corner.y()), pixels(button.width()), pixels(button.height())});
}

HandBar* HandControl::make_bar() {
  HandBar::Actions actions;
  actions.choose_hand = [this](int index) { choose(index); };
  actions.guide = [this](bool on) { console_.guide(on); };
  actions.choose_scale = [this](int index) { console_.scale(index); };
  actions.depth_stop = [this](double depth_um) { console_.depth_stop_um(depth_um); };
  actions.inject = [this](bool held) { console_.inject(held); };
  actions.retract = [this](bool held) { console_.retract(held); };
  if (console_.can_renew()) actions.new_cell = [this] { console_.new_cell(); };
  actions.stop = [this] { emergency_stop(); };
  actions.release_stop = [this] {
    console_.release_emergency_stop();
    show_status();
  };
  return new HandBar(to_list(console_.hands()), to_list(OperatorConsole::scales()), std::move(actions), &window_);
}

void HandControl::choose(int index) {
  dragged_px_.reset();
  feed_widget_.unsetCursor();
  console_.choose(index);
  if (console_.is_mouse()) feed_widget_.setCursor(Qt::OpenHandCursor);
  show_status();
}

void HandControl::tick() {
  console_.update();
  place_stop_button();
}

void HandControl::show_status() {
  std::string doing = console_.doing();
  if (doing.empty() && console_.is_mouse() && !dragged_px_) doing = words("Hold the left button to move the needle");
  bar_->show_texts(hand_texts(console_.status(), doing));
  bar_->set_choice(console_.chosen(), console_.scale());
  bar_->set_depth_stop_um(console_.depth_stop_um());
  bar_->set_manual(!console_.is_demonstration());
}

void HandControl::set_guided(bool on) {
  bar_->set_guided(on);
}

bool HandControl::eventFilter(QObject* target, QEvent* event) {
  if (target == &feed_widget_ && take_feed_event(event)) return true;
  if (target == &window_ && event->type() == QEvent::WindowDeactivate) {
    dragged_px_.reset();
    console_.release_all();
    bar_->hold_release(false);
  }
  const bool pressed = event->type() == QEvent::KeyPress;
  if (!pressed && event->type() != QEvent::KeyRelease) return false;
  const auto& key = static_cast<const QKeyEvent&>(*event);
  // In any window of the program, which may have a use for the key too.
  take_stop_key(key, pressed);
  const auto* widget = qobject_cast<QWidget*>(target);
  return widget && widget->window() == &window_ && take_held_key(key, pressed);
}

void HandControl::take_stop_key(const QKeyEvent& event, bool pressed) {
  if (event.isAutoRepeat() || (event.key() != Qt::Key_Escape && event.key() != Qt::Key_Shift)) return;
  const bool with_shift = (event.modifiers() & Qt::ShiftModifier) != 0;
  if (event.key() == Qt::Key_Escape && pressed && !with_shift) emergency_stop();
  bar_->hold_release(event.key() == Qt::Key_Escape && pressed && with_shift);
}

bool HandControl::take_held_key(const QKeyEvent& event, bool pressed) {
  if (event.modifiers() != Qt::NoModifier && pressed) return false;
  if (event.key() != kInjectKey && event.key() != kRetractKey) return false;
  // A letter that is being typed.
  if (qobject_cast<QLineEdit*>(QApplication::focusWidget())) return false;
  if (event.isAutoRepeat() || console_.is_demonstration()) return true;
  if (event.key() == kInjectKey) {
    console_.inject(pressed);
  } else {
    console_.retract(pressed);
  }
  return true;
}

bool HandControl::take_feed_event(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return take_press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove: {
      if (!dragged_px_) return false;
      const QPointF place_px = static_cast<const QMouseEvent*>(event)->localPos();
      const QPointF way_px = place_px - *dragged_px_;
      console_.move_px(way_px.x(), way_px.y());
      dragged_px_ = place_px;
      return true;
    }
    case QEvent::MouseButtonRelease: {
      if (static_cast<const QMouseEvent*>(event)->button() != Qt::LeftButton) return false;
      if (!dragged_px_) return false;
      dragged_px_.reset();
      console_.grip(false);
      feed_widget_.setCursor(Qt::OpenHandCursor);
      return true;
    }
    case QEvent::Wheel:
      if (!dragged_px_) return false;
      console_.turn_wheel(static_cast<const QWheelEvent*>(event)->angleDelta().y() / kNotch);
      return true;
    default:
      return false;
  }
}

bool HandControl::take_press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  if (!console_.is_mouse()) return false;
  dragged_px_ = event.localPos();
  console_.grip(true);
  feed_widget_.setCursor(Qt::ClosedHandCursor);
  return true;
}

void HandControl::emergency_stop() {
  console_.emergency_stop();
  show_status();
}

}  // namespace pellucida
