#pragma once
#include <QWidget>
#include <string>
#include <vector>

#include "presenters/StartLists.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace pellucida {

class Choice;
struct PixelMeasure;

/// A named control with a place for a note and one for an error below it; hidden while they are empty.
class CardField : public QWidget {
 public:
  /// `object_name` becomes that of the control.
  CardField(const QString& name, QWidget* control, const char* object_name);

  void show_note(const std::string& text);
  /// Marks the control as wrong, and says why; empty: it is right.
  void show_problem(const std::string& text);
  QWidget& control() const { return *control_; }

 private:
  QWidget* control_;
  QLabel* note_;
  QLabel* problem_;
};

/// A list of entries; its popup is as wide as the longest of them.
Choice* make_choice(const std::vector<StartEntry>& entries, const std::string& chosen);
/// The value behind the line chosen; empty without one.
std::string value_of(const Choice& choice);
/// A line for a number, with its unit at the right end.
QLineEdit* make_number_line(const QString& unit, const QString& placeholder, const std::string& text);

/// Opens the measurement of a pixel on an image; and what is said below the field that it filled in.
QPushButton* make_measure_button();
std::string measured_note(const PixelMeasure& measure);

}  // namespace pellucida
