#pragma once
#include <QLabel>

class QHBoxLayout;

namespace pellucida {

/// A label with room for the widest text it will show, so that nothing jumps while numbers run; follows the theme's
/// letters.
class FigureLabel : public QLabel {
 public:
  FigureLabel(const QString& widest, QWidget* parent) : QLabel(parent), widest_(widest) {}
  QSize sizeHint() const override { return widened(QLabel::sizeHint()); }
  QSize minimumSizeHint() const override { return widened(QLabel::minimumSizeHint()); }

 private:
  QSize widened(const QSize& size) const;
  QString widest_;
};

/// A large number below its heading, with a small note beside it where there is one.
struct Figure {
  QLabel* heading = nullptr;
  QLabel* value = nullptr;
  QLabel* note = nullptr;
};

/// Adds one at the row's end. `name`: the value's object name, its note's with "Note" after it. `widest` texts: UTF-8.
Figure add_figure(QHBoxLayout& row, QWidget& parent, const char* name, const QString& heading, const QString& widest,
                  const QString& widest_note = {});

}  // namespace pellucida
