#include "widgets/PhraseLabel.h"

#include <QBoxLayout>
#include <QLabel>

#include "Theme.h"
#include "presenters/Phrase.h"

namespace pellucida {
namespace {

constexpr int kLetters_px = 12;  // as the theme has it
constexpr int kSlack_px = 6;

}  // namespace

QLabel* add_phrase_label(QBoxLayout& row, const QString& widest) {
  auto* label = new QLabel;
  label->setObjectName("statusText");
  QFont letters = label->font();
  letters.setPixelSize(kLetters_px);
  if (!widest.isEmpty()) {
    label->setMinimumWidth(QFontMetrics(letters).horizontalAdvance(widest) + kSlack_px);
  }
  row.addWidget(label);
  return label;
}

void show_phrase(QLabel& label, const Phrase& phrase) {
  label.setText(QString::fromStdString(phrase.text));
  set_sheet(label, "color: " + QString::fromStdString(phrase.color.css()));
}

}  // namespace pellucida
