#pragma once
#include <QFrame>
#include <functional>
#include <initializer_list>
#include <utility>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace pellucida {

/// A line across the window for what must not be overlooked, with buttons that answer it. No dialog: the run, its
/// recording and every key go on beside it, and it stays until it is answered or hidden.
class MessageStrip : public QFrame {
 public:
  using Button = std::pair<QString, std::function<void()>>;

  /// `key`: its object name. `answers`: each hides the strip, then acts.
  MessageStrip(const char* key, std::initializer_list<Button> answers, QWidget* parent);

  void say_text(const QString& text);
  QString text() const;

 private:
  QLabel* text_;
};

}  // namespace pellucida
