#pragma once

class QKeySequence;
class QPushButton;
class QWidget;

namespace pellucida {

/// A button with a menu: the theme, which changes at once, and the language, which the next window has. Both are kept
/// for every mode. `light_key` changes the theme.
QPushButton* make_look_button(const QKeySequence& light_key, QWidget* parent);

}  // namespace pellucida
