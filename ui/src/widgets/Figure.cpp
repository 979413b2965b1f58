#include "widgets/Figure.h"
#include "Words.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

namespace pellucida {
namespace {

constexpr int kFigureSlack_px = 4;

}  // namespace

QSize FigureLabel::widened(const QSize& size) const {
  return {std::max(size.width(), fontMetrics().horizontalAdvance(widest_) + kFigureSlack_px), size.height()};
}

Figure add_figure(QHBoxLayout& row, QWidget& parent, const char* name, const QString& heading, const QString& widest,
                  const QString& widest_note) {
  auto* box = new QVBoxLayout;
  box->setSpacing(0);
  auto* title = new QLabel(heading, &parent);
  title->setObjectName("readoutName");
  box->addWidget(title);

  Figure figure;
  figure.heading = title;
  figure.value = new FigureLabel(widest, &parent);
  figure.value->setObjectName(name);
  figure.value->setProperty("figure", true);
  auto* line = new QHBoxLayout;
  line->setSpacing(10);
  line->addWidget(figure.value);
  if (!widest_note.isEmpty()) {
    figure.note = new FigureLabel(widest_note, &parent);
    figure.note->setObjectName(QString(name) + "Note");
    figure.note->setProperty("figureNote", true);
    figure.note->setContentsMargins(0, 0, 0, 3);
    line->addWidget(figure.note, 0, Qt::AlignBottom);
  }
  box->addLayout(line);
  row.addLayout(box);
  return figure;
}

}  // namespace pellucida
