#pragma once
#include <QWidget>
#include <functional>

class QHBoxLayout;
class QKeySequence;
class QPushButton;

namespace pellucida {

/// The line at a window's top: the program's mark and name, then buttons with keys.
class TitleBar : public QWidget {
 public:
  explicit TitleBar(QWidget* parent);

  QPushButton* add_button(const QString& text, const QKeySequence& key, const QString& tip,
                          std::function<void()> action);
  /// A button that has no key: for a menu.
  QPushButton* add_menu_button(const QString& text, const QString& tip);
  /// Back to the start page.
  void add_start_button();
  /// Theme and language, and the sheet of keys; `light_key` changes the theme.
  void add_look_menu(const QKeySequence& light_key = QKeySequence("Ctrl+L"));
  /// A name at the right end, after which nothing is added; `shows_blocks`: before it, how often the window was busy.
  void add_name(const QString& name, const QString& tip, bool shows_blocks = false);

 private:
  QHBoxLayout* row_;
};

}  // namespace pellucida
