#pragma once
#include <QPointer>
#include <functional>

class QMessageBox;
class QWidget;

namespace pellucida {

/// Asks once before a window that records is closed. The question stands beside the live view and blocks nothing.
class ClosingQuestion {
 public:
  /// `end_recording` may throw nothing. Both must outlive the question.
  ClosingQuestion(QWidget& window, std::function<void()> end_recording);

  /// From the window's closing event: true where it may close now; else the question is on screen.
  bool may_close(bool recording);

 private:
  void ask();

  QWidget& window_;
  std::function<void()> end_recording_;
  QPointer<QMessageBox> box_;
};

}  // namespace pellucida
