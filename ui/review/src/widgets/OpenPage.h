#pragma once
#include <QWidget>
#include <functional>

class QLabel;
class QPushButton;

namespace pellucida {

/// What the window shows without a session: a button that asks for one, and why the last one couldn't be opened.
class OpenPage : public QWidget {
 public:
  OpenPage(std::function<void()> open, QWidget* parent);

  /// A session is being read.
  void show_reading(const QString& folder);
  void show_problem(const QString& text);

 private:
  QLabel* text_;
  QLabel* problem_;
  QPushButton* open_;
};

}  // namespace pellucida
