#pragma once
#include <QFrame>
#include <QKeySequence>
#include <QString>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace pellucida {

/// A view with a head line: title on the left, controls on the right. Where there is no room for both, the controls.
class Panel : public QFrame {
 public:
  Panel(const QString& title, QWidget* content, QWidget* parent);

  /// Puts a control at the right end of the head line.
  void add_control(QWidget* control);
  /// Puts a control in the title's place.
  void lead_with(QWidget* control);
  /// A button that stays down while its thing is shown.
  QToolButton* add_toggle(const QString& text, const QString& tip, const QKeySequence& key, bool on);
  /// A plain button; without `key` the mouse alone reaches it.
  QToolButton* add_button(const QString& text, const QString& tip, const QKeySequence& key = {});

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QLabel* title_;
  QHBoxLayout* head_;
};

}  // namespace pellucida
