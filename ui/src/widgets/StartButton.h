#pragma once

class QPushButton;
class QWidget;

namespace pellucida {

/// A button for a window's top bar that leads back to the start page, by mouse or by Alt+Home.
QPushButton* make_start_button(QWidget* parent);

}  // namespace pellucida
