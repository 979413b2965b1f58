#pragma once
#include <QFrame>
#include <QString>
#include <vector>

class QBoxLayout;
class QPushButton;
class QScrollArea;

namespace pellucida {

/// A key, or a gesture of the mouse, and what it does.
struct KeyEntry {
  QString group;    ///< the part of the window it belongs to
  QString keys;     ///< "Ctrl+S"
  QString meaning;  ///< as the tip or the menu says it
};

/// All keys and gestures of a window, as its buttons, actions and shortcuts have them: nothing is listed twice, and
/// nothing by hand. A shortcut that is neither a button's nor an action's says by its `whatsThis` what it does; a key
/// that is handled as an event is named by the tip of the button that does the same.
std::vector<KeyEntry> keys_of_window(const QWidget& window);

/// Names the part of a window whose keys stand together on its sheet.
void set_key_group(QWidget& part, const QString& name);
/// What the mouse does on a widget, for the sheet.
void explain_gesture(QWidget& place, const QString& gesture, const QString& meaning);
/// Where the sheet may lie: what is beside it (an emergency stop) stays in sight. Without one: below the top bar.
void set_sheet_place(QWidget& place);

/// A sheet with all keys of its window, over a part of it. It is no dialog: what runs goes on, and every key and button
/// beside it acts. Esc closes it, and still is the emergency stop where the window has one.
class KeySheet : public QFrame {
 public:
  /// Shows the sheet of `window`, or closes the one that is shown.
  static void toggle(QWidget& window);

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  explicit KeySheet(QWidget& window);
  void fill();
  void place();

  std::vector<KeyEntry> entries_;
  QScrollArea* scroll_;
};

/// The button that shows and hides the sheet, with its key, F1.
QPushButton* make_keys_button(QWidget* parent);

}  // namespace pellucida
