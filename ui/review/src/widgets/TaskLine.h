#pragma once
#include <QWidget>
#include <functional>

class QLabel;
class QProgressBar;

namespace pellucida {

struct Phrase;

/// The line at the bottom of the window in Review mode: what a person should know of the frame shown, and how far work
/// in the background is.
class TaskLine : public QWidget {
 public:
  /// `cancel`: the button beside the progress.
  TaskLine(std::function<void()> cancel, QWidget* parent);

  void show_notice(const Phrase& phrase);
  /// What is being done, and how much of it; `all` 0: it can't be said how much. An empty text: nothing is being done.
  void show_work(const QString& text, std::size_t done, std::size_t all);

 private:
  QLabel* notice_;
  QLabel* work_;
  QProgressBar* progress_;
  QWidget* cancel_;
};

}  // namespace pellucida
