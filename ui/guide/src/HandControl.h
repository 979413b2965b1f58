#pragma once
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QPointF>
#include <functional>
#include <memory>
#include <optional>

#include "pellucida/operation/OperatorConsole.h"

class QKeyEvent;
class QMouseEvent;

namespace pellucida {

class HandBar;
class StopListener;
class ViewWidget;

/// Joins the hand's console with the window: the bar, the mouse on the feed, the keys held.
///
/// On the feed: the left button held moves the needle while mouse and keyboard is the hand, the wheel meanwhile moves
/// it in depth. Keys: D deposits and X retracts while held, Esc stops, Shift+Esc held
/// for a second releases the stop. When the window is no longer the active one nothing is held any more.
///
/// The stop does not wait for the window's thread where a StopListener listens: Esc and STOP then reach the 1 kHz loop
/// while the window still draws.
class HandControl : public QObject {
 public:
  /// All must outlive the control but the bar, which belongs to `window`.
  HandControl(OperatorConsole& console, ViewWidget& feed_widget, QWidget& window);
  ~HandControl() override;

  /// The keys it handles itself, beside the window's shortcuts.
  static QList<QKeySequence> keys();

  HandBar* bar() const noexcept { return bar_; }
  /// From the window's tick.
  void tick();
  void show_status();
  /// As the bar's Guide button.
  void set_guided(bool on);

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  HandBar* make_bar();
  void choose(int index);
  bool take_feed_event(QEvent* event);
  bool take_press(const QMouseEvent& event);
  bool take_held_key(const QKeyEvent& event, bool pressed);
  void take_stop_key(const QKeyEvent& event, bool pressed);
  void listen_for_stop();
  void place_stop_button();
  void emergency_stop();

  OperatorConsole& console_;
  ViewWidget& feed_widget_;
  QWidget& window_;
  HandBar* bar_;
  std::unique_ptr<StopListener> listener_;
  std::optional<QPointF> dragged_px_;  // while the mouse leads the needle
};

}  // namespace pellucida
