#include "widgets/ButtonKey.h"

#include <QAbstractButton>
#include <QShortcut>

namespace pellucida {

QString tip_with_key(const QString& text, const QKeySequence& key) {
  return text + " (" + key.toString(QKeySequence::PortableText) + ")";
}

void bind_key(QAbstractButton& button, const QKeySequence& key, const QString& tip, bool repeats) {
  button.setToolTip(tip_with_key(tip, key));
  // Not the button's own shortcut: that is lost with each new text, and acts a tenth of a second late.
  auto* shortcut = new QShortcut(key, &button);
  shortcut->setAutoRepeat(repeats);
  QObject::connect(shortcut, &QShortcut::activated, &button, &QAbstractButton::click);
}

void add_window_key(QWidget& window, const QKeySequence& key, const QString& meaning, std::function<void()> action,
                    bool repeats) {
  auto* shortcut = new QShortcut(key, &window);
  shortcut->setWhatsThis(meaning);
  shortcut->setAutoRepeat(repeats);
  QObject::connect(shortcut, &QShortcut::activated, &window, std::move(action));
}

}  // namespace pellucida
