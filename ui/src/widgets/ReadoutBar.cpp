#include "widgets/ReadoutBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "Theme.h"
#include "presenters/StatusPresenter.h"
#include "widgets/PhraseLabel.h"

namespace pellucida {

ReadoutBar::ReadoutBar(QWidget* parent) : QFrame(parent) {
  setObjectName("readoutBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(66);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 6, 16, 8);
  row->setSpacing(34);

  state_ = new QLabel(this);
  state_->setObjectName("statePill");
  state_->setAlignment(Qt::AlignCenter);
  state_->setFixedSize(132, 30);
  row->addWidget(state_);
  // Room for the widest value, so that nothing jumps while the numbers run.
  indentation_ = add_figure(row, "INDENTATION", "000.0 µm");
  force_ = add_figure(row, "FORCE OF THE NEEDLE", "0.00 µN", "95 %: 00.00 – 00.00 µN");
  pressure_ = add_figure(row, "PRESSURE", "0000 Pa");
  confidence_ = add_figure(row, "CONFIDENCE", "100 %");
  row->addStretch(1);
}

ReadoutBar::Figure ReadoutBar::add_figure(QHBoxLayout* row, const char* name, const char* widest,
                                          const char* widest_note) {
  auto* box = new QVBoxLayout;
  box->setSpacing(0);
  auto* title = new QLabel(name, this);
  title->setObjectName("readoutName");
  box->addWidget(title);

  Figure figure;
  figure.value = new QLabel(this);
  QFont letters = figure.value->font();
  letters.setPixelSize(23);
  letters.setBold(true);
  figure.value->setFont(letters);
  figure.value->setMinimumWidth(QFontMetrics(letters).horizontalAdvance(QString::fromUtf8(widest)) + 4);
  auto* line = new QHBoxLayout;
  line->setSpacing(10);
  line->addWidget(figure.value);
  if (widest_note) {
    figure.note = new QLabel(this);
    figure.note->setObjectName("readoutNote");
    QFont small = figure.note->font();
    small.setPixelSize(12);
    figure.note->setMinimumWidth(QFontMetrics(small).horizontalAdvance(QString::fromUtf8(widest_note)) + 4);
    figure.note->setContentsMargins(0, 0, 0, 3);
    line->addWidget(figure.note, 0, Qt::AlignBottom);
  }
  box->addLayout(line);
  row->addLayout(box);
  return figure;
}

void ReadoutBar::show_texts(const StatusTexts& texts) {
  state_->setText(QString::fromStdString(texts.state.text));
  state_->setStyleSheet("background: " + QString::fromStdString(texts.state.color.css()));
  show_phrase(*indentation_.value, texts.indentation);
  show_phrase(*force_.value, texts.force);
  force_.note->setText(QString::fromStdString(texts.force_interval));
  show_phrase(*pressure_.value, texts.pressure);
  show_phrase(*confidence_.value, texts.confidence);
}

}  // namespace pellucida
