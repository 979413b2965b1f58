#pragma once
#include <QKeySequence>
#include <QString>
#include <functional>

class QAbstractButton;
class QWidget;

namespace pellucida {

/// "Text (key)": how every tip in the window names its key.
QString tip_with_key(const QString& text, const QKeySequence& key);

/// The key clicks the button, wherever the window has its focus, and the button's tip names the key. A key may be given
/// once in a window: one given twice does nothing. `repeats`: again and again while the key is held.
void bind_key(QAbstractButton& button, const QKeySequence& key, const QString& tip, bool repeats = false);

/// A key of the whole window that no button has; `meaning`: what the sheet of keys says of it.
void add_window_key(QWidget& window, const QKeySequence& key, const QString& meaning, std::function<void()> action,
                    bool repeats = true);

}  // namespace pellucida
