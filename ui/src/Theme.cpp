#include "Theme.h"

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QPalette>
#include <QString>
#include <QStyleFactory>

#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

// What can't be used now: between the dim text and the borders.
constexpr Color kFaint = Color::from_hex(0x66737F);

// The sheet names colours as @name; they are filled in from the palette.
const char* const kSheet = R"(
QMainWindow, QDialog { background: @window; }
QWidget { color: @text; }
QToolTip { background: @raised; color: @text; border: 1px solid @border; padding: 4px 6px; }
#topBar, #panelHead, #statusLine, #readoutBar, #handBar, #transportBar, #nodeFacts { background: @panel; }
#topBar { border-bottom: 1px solid @border; }
#statusLine { border-top: 1px solid @border; }
#brand { font-size: 19px; font-weight: 700; }
#sourceCaption, #statusText, #notice, #facts, #place, #nodeFactName { color: @dim; font-size: 12px; }
#sourceName { font-size: 13px; font-weight: 600; }
#panelTitle { font-size: 13px; font-weight: 600; }
#readoutName { color: @dim; font-size: 11px; font-weight: 600; }
#forceNote { color: @dim; font-size: 12px; }
#statePill { border-radius: 15px; padding: 0px 18px; font-size: 15px; font-weight: 700; color: @window; }
#nodeFact { font-size: 12px; }
#pageTitle { font-size: 22px; font-weight: 600; }
#pageText { color: @dim; font-size: 14px; }
#problem { font-size: 14px; }
QPushButton[lit="true"]:checked:enabled { border-color: @accent; background: @border; }
QPushButton[narrow="true"] { padding: 0px; font-size: 15px; }
QTreeWidget { background: @panel; border: none; font-size: 12px; outline: none; }
QTreeWidget::item { padding: 3px 6px; border: none; background: transparent; }
QTreeWidget::item:selected { background: @border; color: @text; }
QTreeWidget::item:hover { background: @raised; }
QHeaderView::section { background: @panel; color: @dim; border: none; border-bottom: 1px solid @border; padding: 3px 6px; font-size: 11px; font-weight: 600; }
QScrollBar:vertical { background: @panel; width: 10px; margin: 0px; }
QScrollBar::handle:vertical { background: @border; border-radius: 5px; min-height: 24px; }
QScrollBar::add-line:vertical, QScrollBar::sub-line:vertical { height: 0px; }
QMenu::item:disabled { color: @faint; }
QMenu::separator { height: 1px; background: @border; margin: 4px 6px; }
#handBar { border-top: 1px solid @border; }
#handPill { border-radius: 11px; font-size: 12px; font-weight: 700; color: @window; }
QToolButton, QPushButton { background: @raised; border: 1px solid @border; border-radius: 6px; padding: 4px 10px; font-size: 12px; }
QToolButton:hover, QPushButton:hover { border-color: @accent; }
QToolButton:pressed, QPushButton:pressed { background: @border; }
QToolButton:disabled, QPushButton:disabled { color: @faint; background: @panel; }
QToolButton:focus, QPushButton:focus { border-color: @accent; }
QToolButton[flat="true"] { background: transparent; border-color: transparent; color: @dim; padding: 3px 8px; }
QToolButton[flat="true"]:hover { border-color: @border; color: @text; }
QToolButton[flat="true"]:checked { background: @raised; border-color: @border; color: @text; }
QPushButton#record:checked { border-color: @record; font-weight: 700; }
QPushButton#guide:checked { border-color: @plan; color: @plan; font-weight: 600; }
QPushButton#emergencyStop { background: @record; border-color: @record; color: @window; font-weight: 800; font-size: 17px; letter-spacing: 1px; }
QPushButton#emergencyStop[latched="true"] { background: @panel; color: @record; border-width: 2px; font-size: 15px; }
QPushButton#emergencyStop:hover { border-color: @text; }
QPushButton#releaseStop { padding: 0px; }
QComboBox, QDoubleSpinBox { background: @raised; border: 1px solid @border; border-radius: 6px; padding: 3px 8px; font-size: 12px; }
QComboBox:hover, QDoubleSpinBox:hover, QComboBox:focus, QDoubleSpinBox:focus { border-color: @accent; }
QComboBox:disabled, QDoubleSpinBox:disabled { color: @faint; background: @panel; }
QComboBox::drop-down { border: none; width: 22px; }
QComboBox QAbstractItemView { background: @raised; border: 1px solid @border; selection-background-color: @border; }
QProgressBar { background: @border; border: none; border-radius: 4px; }
QProgressBar::chunk { background: @accent; border-radius: 4px; }
QToolButton::menu-indicator, QPushButton::menu-indicator { image: none; width: 0px; }
QPushButton { padding: 0px 12px; }
QMenu::item { padding: 5px 22px 5px 8px; font-size: 12px; border-radius: 4px; }
QMenu::item:selected { background: @border; }
QMenu { background: @raised; border: 1px solid @border; padding: 6px; }
QMenu QLabel { font-size: 12px; }
QCheckBox { font-size: 12px; spacing: 8px; }
QSlider::groove:horizontal { height: 4px; background: @border; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @accent; border-radius: 2px; }
QSlider::handle:horizontal { width: 14px; height: 14px; margin: -5px 0; border-radius: 7px; background: @text; }
QSplitter::handle { background: @window; }
QSplitter::handle:hover { background: @border; }
)";

}  // namespace

QColor to_qt(const Color& color) {
  return QColor::fromRgbF(color.red, color.green, color.blue);
}

void apply_theme(QApplication& app) {
  app.setStyle(QStyleFactory::create("Fusion"));
  QPalette colors;
  colors.setColor(QPalette::Window, to_qt(palette::kWindow));
  colors.setColor(QPalette::Base, to_qt(palette::kPanel));
  colors.setColor(QPalette::AlternateBase, to_qt(palette::kRaised));
  colors.setColor(QPalette::Button, to_qt(palette::kRaised));
  colors.setColor(QPalette::ToolTipBase, to_qt(palette::kRaised));
  colors.setColor(QPalette::Highlight, to_qt(palette::kAccent));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    colors.setColor(role, to_qt(palette::kText));
  }
  colors.setColor(QPalette::HighlightedText, to_qt(palette::kWindow));
  app.setPalette(colors);

  QString sheet = QString::fromUtf8(kSheet);
  const std::pair<const char*, Color> names[] = {{"@window", palette::kWindow}, {"@panel", palette::kPanel},
                                                 {"@raised", palette::kRaised}, {"@border", palette::kBorder},
                                                 {"@text", palette::kText},     {"@dim", palette::kTextDim},
                                                 {"@accent", palette::kAccent}, {"@record", palette::kRecord},
                                                 {"@plan", palette::kPlan},     {"@faint", kFaint}};
  for (const auto& [name, color] : names) sheet.replace(name, QString::fromStdString(color.css()));
  app.setStyleSheet(sheet);
}

}  // namespace pellucida
