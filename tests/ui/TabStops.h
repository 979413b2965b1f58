#pragma once
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAccessible>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabBar>
#include <QWidget>
#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace pellucida::test {

/// Which widget a person would take this one for.
inline std::string widget_text(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  return std::string(widget.metaObject()->className()) + " \"" + widget.objectName().toStdString() + "\" " +
         (button ? button->text().toStdString() : std::string());
}

/// What a screen reader says of it.
inline std::string spoken_name(QWidget& widget) {
  QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(&widget);
  return spoken ? spoken->text(QAccessible::Name).trimmed().toStdString() : std::string();
}

/// The widgets that Tab comes to, in its order, from where the window has its focus round to there again. Precondition:
/// the window is active.
inline std::vector<QWidget*> tab_stops(QWidget& window) {
  std::vector<QWidget*> stops;
  std::set<QWidget*> seen;
  for (int k = 0; k < 400; ++k) {
    QWidget* at = QApplication::focusWidget() ? QApplication::focusWidget() : &window;
    QKeyEvent press(QEvent::KeyPress, Qt::Key_Tab, Qt::NoModifier),
        release(QEvent::KeyRelease, Qt::Key_Tab, Qt::NoModifier);
    QApplication::sendEvent(at, &press);
    QApplication::sendEvent(at, &release);
    QWidget* now = QApplication::focusWidget();
    if (!now || !seen.insert(now).second) break;
    stops.push_back(now);
  }
  return stops;
}

/// Controls that are seen and act, but to which neither Tab nor, within a group of radio buttons, an arrow comes.
inline std::vector<QWidget*> controls_without_stop(QWidget& window, const std::vector<QWidget*>& stops) {
  std::vector<QWidget*> missed;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    const bool is_control = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
                            (qobject_cast<QAbstractSlider*>(widget) && !qobject_cast<QScrollBar*>(widget)) ||
                            qobject_cast<QLineEdit*>(widget) || qobject_cast<QAbstractItemView*>(widget) ||
                            qobject_cast<QTabBar*>(widget);
    if (!is_control || !widget->isVisible() || !widget->isEnabled() || widget->window() != &window) continue;
    // Parts of a control: a list of nothing to choose, the arrows of a bar of tabs, what a field is edited in.
    const auto* list = qobject_cast<QAbstractItemView*>(widget);
    if (list && list->selectionMode() == QAbstractItemView::NoSelection) continue;
    if (qobject_cast<QTabBar*>(widget->parentWidget()) || qobject_cast<QComboBox*>(widget->parentWidget())) continue;
    const auto* button = qobject_cast<QAbstractButton*>(widget);
    if (button && button->group() && button->group()->exclusive() && button->group()->checkedButton() != button &&
        button->group()->buttons().front() != button) {
      continue;
    }
    if (std::find(stops.begin(), stops.end(), widget) == stops.end()) missed.push_back(widget);
  }
  return missed;
}

}  // namespace pellucida::test
