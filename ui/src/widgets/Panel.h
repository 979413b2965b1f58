#pragma once
#include <QFrame>
#include <QString>

class QHBoxLayout;
class QToolButton;

namespace pellucida {

/// A view with a head line: title on the left, controls on the right.
class Panel : public QFrame {
 public:
  Panel(const QString& title, QWidget* content, QWidget* parent);

  /// Puts a control at the right end of the head line.
  void add_control(QWidget* control);
  /// A button that stays down while its thing is shown. `tip` names the key.
  QToolButton* add_toggle(const QString& text, const QString& tip, bool on);
  /// A plain button.
  QToolButton* add_button(const QString& text, const QString& tip);

 private:
  QHBoxLayout* head_;
};

}  // namespace pellucida
