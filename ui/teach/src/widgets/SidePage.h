#pragma once
#include <QWidget>

class QComboBox;
class QTabWidget;
class QVBoxLayout;

namespace pellucida {

/// A page of controls below each other, in the order in which they are added.
class SidePage : public QWidget {
 public:
  explicit SidePage(QWidget* parent);

  /// A choice with its name above it.
  QComboBox* add_choice(const QString& name, const char* object_name, const QString& tip);
  /// A small text in as many lines as it needs.
  void add_note(const QString& text);
  void add(QWidget* control);
  /// Nothing is added after it.
  void end();

 private:
  QVBoxLayout* column_;
};

/// A page that scrolls where it is higher than its place.
QWidget* scrolled(QWidget* page);

/// Tabs for such pages.
QTabWidget* make_side_tabs();

/// A view with a chart below it, to be divided as one likes.
QWidget* view_over_chart(QWidget* view, QWidget* chart);

}  // namespace pellucida
