#include "Theme.h"

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QPalette>
#include <QRegularExpression>
#include <QString>
#include <QStyleFactory>
#include <QWidget>
#include <utility>
#include <vector>

#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

double type_scale_applied = 1.0;

// The sheet names colours as @name; they are filled in from the palette.
const char* const kSheet = R"(
QMainWindow, QDialog { background: @window; }
QWidget { color: @text; }
QToolTip { background: @raised; color: @text; border: 1px solid @border; padding: 4px 6px; }
#topBar, #panelHead, #statusLine, #readoutBar, #gaugeBar, #factLine, #handBar, #transportBar, #hintStrip, #noteStrip, #recordStrip, #cellDrawer, #nodeFacts, #chartFacts { background: @panel; }
#topBar { border-bottom: 1px solid @border; }
#statusLine { border-top: 1px solid @border; }
#brand { font-size: 19px; font-weight: 700; }
#sourceCaption, #statusText, #notice, #facts, #place, #nodeFactName, #chartFacts { color: @dim; font-size: 12px; }
#sourceName { font-size: 13px; font-weight: 600; }
#panelTitle { font-size: 13px; font-weight: 600; }
#readoutName { color: @dim; font-size: 11px; font-weight: 600; }
#statePill { border-radius: 15px; padding: 0px 10px; font-size: 15px; font-weight: 700; color: @window; }
#nodeFact { font-size: 12px; }
#pageTitle { font-size: 22px; font-weight: 600; }
#pageText { color: @dim; font-size: 14px; }
#problem { font-size: 14px; }
QPushButton[lit="true"]:checked:enabled { border-color: @accent; background: @raised; }
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
#topBar QPushButton:checked { border-color: @accent; color: @accent; }
#topBar QPushButton#record:checked { border-color: @record; color: @record; }
QMenu::item { padding: 5px 22px 5px 8px; font-size: 12px; border-radius: 4px; }
QMenu::item:selected { background: @border; }
QMenu { background: @raised; border: 1px solid @border; padding: 6px; }
QMenu QLabel { font-size: 12px; }
QCheckBox { font-size: 12px; spacing: 8px; }
QCheckBox::indicator, QRadioButton::indicator { width: 13px; height: 13px; border: 1px solid @faint; background: @raised; }
QCheckBox::indicator { border-radius: 3px; }
QRadioButton::indicator { border-radius: 7px; }
QCheckBox::indicator:hover, QRadioButton::indicator:hover { border-color: @accent; }
QCheckBox::indicator:checked, QRadioButton::indicator:checked { background: @accent; border-color: @accent; }
QSlider::groove:horizontal { height: 4px; background: @border; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @accent; border-radius: 2px; }
QSlider::handle:horizontal { width: 14px; height: 14px; margin: -5px 0; border-radius: 7px; background: @text; }
QLabel[figure="true"] { font-size: 23px; font-weight: 700; }
QLabel[gaugeName="true"] { color: @dim; font-size: 13px; font-weight: 700; }
QLabel[gaugeAlarm="true"] { font-size: 13px; font-weight: 800; border-radius: 4px; padding: 1px 7px; }
QLabel[gaugeTruth="true"] { color: @good; font-size: 13px; font-weight: 700; }
QLabel[gaugeValue="true"] { font-weight: 700; }
QLabel[gaugeNote="true"] { color: @dim; font-size: 12px; }
QLabel[fact="true"] { font-size: 15px; font-weight: 700; }
QLabel[kept="true"] { border: 1px solid @border; border-radius: 5px; padding: 1px 7px; }
QLabel[smallFigure="true"] { font-size: 14px; font-weight: 700; }
QLabel[figureNote="true"] { color: @dim; font-size: 12px; }
#keySheet { background: @panel; border: 1px solid @accent; border-radius: 10px; }
QLabel[sheetTitle="true"] { font-size: 15px; font-weight: 700; }
QLabel[sheetGroup="true"] { color: @accent; font-size: 12px; font-weight: 700; padding-top: 6px; }
QLabel[keyCap="true"] { background: @raised; border: 1px solid @border; border-radius: 4px; padding: 0px 6px; font-size: 12px; font-weight: 600; }
QLabel[keyMeaning="true"] { font-size: 12px; }
#startCard { background: @panel; border: 1px solid @border; border-radius: 10px; }
#startCard[current="true"] { border: 1px solid @accent; }
#startCard QScrollArea, #startCard #cardFields { background: transparent; }
#cardTitle { font-size: 15px; font-weight: 700; }
#cardNumber { color: @faint; font-size: 13px; font-weight: 600; }
#cardText, #fieldNote { color: @dim; font-size: 12px; }
#fieldName { font-size: 12px; font-weight: 600; }
#fieldProblem, #cardProblem { color: @record; font-size: 12px; }
#fieldUnit { color: @dim; font-size: 12px; }
#computedSize { color: @accent; font-size: 13px; font-weight: 600; }
#startCard QLineEdit, #pixelSizeDialog QLineEdit { background: @raised; border: 1px solid @border; border-radius: 6px; padding: 3px 8px; font-size: 12px; selection-background-color: @accent; selection-color: @window; }
#startCard QLineEdit[blank="true"], #pixelSizeDialog QLineEdit[blank="true"] { color: @dim; }
#startCard QLineEdit:hover, #startCard QLineEdit:focus, #pixelSizeDialog QLineEdit:hover, #pixelSizeDialog QLineEdit:focus { border-color: @accent; }
QFrame[message="true"] { background: @raised; border: none; border-left: 6px solid @warning; }
QFrame[message="true"] QLabel { font-size: 15px; font-weight: 600; }
#problemStrip { border-left: 6px solid @record; }
QLineEdit[typed="true"] { background: @raised; border: 1px solid @border; border-radius: 6px; padding: 3px 8px; font-size: 13px; selection-background-color: @accent; selection-color: @window; }
QLineEdit[typed="true"]:focus { border-color: @accent; }
QLineEdit[typed="true"][blank="true"] { color: @dim; }
#noteText { background: @raised; border: 1px solid @border; border-radius: 6px; padding: 3px 8px; font-size: 13px; selection-background-color: @accent; selection-color: @window; }
#noteText:focus { border-color: @accent; }
#noteWhere { color: @dim; font-size: 12px; }
#startCard QListWidget { background: @raised; border: 1px solid @border; border-radius: 6px; font-size: 12px; }
#startCard QListWidget:focus { border-color: @accent; }
#startCard QCheckBox:focus { color: @accent; }
QPushButton#startRun { font-size: 13px; font-weight: 700; }
#startCard[current="true"] QPushButton#startRun { background: @accent; border-color: @accent; color: @window; }
#startCard[current="true"] QPushButton#startRun:focus, #startCard[current="true"] QPushButton#startRun:hover { border-color: @text; }
#recentTitle { font-size: 13px; font-weight: 600; }
QToolButton[recent="true"] { background: @panel; border: 1px solid @border; border-radius: 8px; padding: 6px; font-size: 12px; }
QToolButton[recent="true"]:focus, QToolButton[recent="true"]:hover { border-color: @accent; }
#banner { background: @record; }
#banner QLabel { color: @window; font-size: 14px; font-weight: 600; }
#lessonTitle { font-size: 18px; font-weight: 700; }
#lessonText { font-size: 14px; }
#lessonHead { color: @accent; font-size: 13px; font-weight: 700; }
#rightAnswer { color: @good; font-size: 14px; font-weight: 600; }
#wrongAnswer, #pictureFault { color: @record; font-size: 14px; font-weight: 600; }
#parameterName { font-size: 13px; font-weight: 600; }
#parameterValue { color: @accent; font-size: 13px; font-weight: 600; }
#parameterNote { color: @dim; font-size: 12px; }
QListWidget { background: @panel; border: none; font-size: 13px; outline: none; }
QListWidget::item { padding: 5px 8px; border-radius: 5px; }
QListWidget::item:selected { background: @border; color: @text; }
QTableWidget { background: @panel; border: none; gridline-color: @border; font-size: 12px; }
QHeaderView::section { background: @raised; color: @dim; border: none; padding: 4px; font-size: 12px; }
QTabWidget::pane { border: none; }
QTabBar { font-size: 13px; }
QTabBar::tab { background: transparent; color: @dim; padding: 8px 12px; border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: @text; border-bottom: 2px solid @accent; }
QScrollArea { border: none; background: @panel; }
#page { background: @panel; }
QRadioButton { font-size: 14px; spacing: 8px; }
QScrollBar:vertical { background: @panel; width: 10px; margin: 0px; }
QScrollBar::handle:vertical { background: @border; border-radius: 4px; min-height: 30px; }
QScrollBar::add-line:vertical, QScrollBar::sub-line:vertical { height: 0px; }
QSplitter::handle { background: @window; }
QSplitter::handle:hover { background: @border; }
)";

// Every size of letters times `scale`.
QString scaled(const QString& sheet, double scale) {
  static const QRegularExpression size(R"(font-size: (\d+)px)");
  QString result;
  int from = 0;
  for (auto found = size.globalMatch(sheet); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    result += sheet.mid(from, match.capturedStart() - from);
    result += QString("font-size: %1px").arg(qRound(scale * match.captured(1).toInt()));
    from = match.capturedEnd();
  }
  return result + sheet.mid(from);
}

// A phrase has the colour it was written with in a sheet of its own: the same role's colour in the new theme.
void recolor_labels(const ThemeColors& before, const ThemeColors& now) {
  std::vector<std::pair<QString, QString>> colors;
  const auto add = [&](const Color& from, const Color& to) {
    colors.emplace_back(QString::fromStdString(from.css()), QString::fromStdString(to.css()));
  };
  for (const Color ThemeColors::*role :
       {&ThemeColors::window, &ThemeColors::text, &ThemeColors::text_dim, &ThemeColors::accent, &ThemeColors::record,
        &ThemeColors::warning, &ThemeColors::good, &ThemeColors::plan}) {
    add(before.*role, now.*role);
  }
  for (const auto state : {CellState::kNoCell, CellState::kFree, CellState::kContact, CellState::kPunctured}) {
    add(state_color(state, before), state_color(state, now));
  }
  for (QWidget* widget : QApplication::allWidgets()) {
    const QString sheet = widget->styleSheet();
    if (!sheet.contains('#')) continue;
    static const QRegularExpression hex("#[0-9a-f]{6}");
    QString changed = sheet;
    for (auto found = hex.globalMatch(sheet); found.hasNext();) {
      const QRegularExpressionMatch match = found.next();
      for (const auto& [from, to] : colors) {
        if (match.captured() == from) changed.replace(match.capturedStart(), match.capturedLength(), to);
      }
    }
    if (changed != sheet) widget->setStyleSheet(changed);
  }
}

}  // namespace

QColor to_qt(const Color& color) {
  return QColor::fromRgbF(color.red, color.green, color.blue);
}

double applied_type_scale() noexcept {
  return type_scale_applied;
}

void set_sheet(QWidget& widget, const QString& sheet) {
  if (widget.styleSheet() != sheet) widget.setStyleSheet(sheet);
}

void apply_theme(QApplication& app, const ThemeColors& theme, double type_scale) {
  const ThemeColors& before = current_theme();
  set_current_theme(theme);
  type_scale_applied = type_scale;
  app.setStyle(QStyleFactory::create("Fusion"));
  QPalette colors;
  colors.setColor(QPalette::Window, to_qt(theme.window));
  colors.setColor(QPalette::Base, to_qt(theme.panel));
  colors.setColor(QPalette::AlternateBase, to_qt(theme.raised));
  colors.setColor(QPalette::Button, to_qt(theme.raised));
  colors.setColor(QPalette::ToolTipBase, to_qt(theme.raised));
  colors.setColor(QPalette::Highlight, to_qt(theme.accent));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    colors.setColor(role, to_qt(theme.text));
  }
  colors.setColor(QPalette::HighlightedText, to_qt(theme.window));
  app.setPalette(colors);

  QString sheet = QString::fromUtf8(kSheet);
  const std::pair<const char*, Color> names[] = {
      {"@window", theme.window}, {"@panel", theme.panel},  {"@raised", theme.raised},   {"@border", theme.border},
      {"@text", theme.text},     {"@dim", theme.text_dim}, {"@accent", theme.accent},   {"@record", theme.record},
      {"@plan", theme.plan},     {"@faint", theme.faint},  {"@warning", theme.warning}, {"@good", theme.good}};
  for (const auto& [name, color] : names) sheet.replace(name, QString::fromStdString(color.css()));
  app.setStyleSheet(scaled(sheet, type_scale));
  if (before.is_light != theme.is_light) recolor_labels(before, theme);
}

}  // namespace pellucida
