#pragma once
#include <QElapsedTimer>
#include <QPushButton>
#include <QTimer>
#include <functional>

namespace pellucida {

/// A button for what must not happen by accident: it acts once it has been held down for a second, and fills meanwhile.
/// Released, left or hidden before, it does nothing.
class HoldButton : public QPushButton {
 public:
  static constexpr double kHold_s = 1.0;

  /// `action`: on the window's thread, once for each time it was held long enough.
  HoldButton(const QString& text, std::function<void()> action, QWidget* parent);

  /// Holds it down by other means than the mouse, a key for instance; released by false.
  void hold(bool held);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void advance();

  std::function<void()> action_;
  QTimer timer_;
  QElapsedTimer since_;  // the last step
  double held_s_ = 0.0;
};

}  // namespace pellucida
