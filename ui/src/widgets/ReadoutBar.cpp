#include "widgets/ReadoutBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "Theme.h"
#include "presenters/ReadoutPresenter.h"
#include "widgets/PhraseLabel.h"

namespace pellucida {
namespace {

constexpr int kRoomy_px = 1200;

}  // namespace

ReadoutBar::ReadoutBar(QWidget* parent) : QFrame(parent) {
  setObjectName("readoutBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(66);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 6, 16, 8);

  state_ = new QLabel(this);
  state_->setObjectName("statePill");
  state_->setAlignment(Qt::AlignCenter);
  state_->setFixedSize(132, 30);
  row->addWidget(state_);
  // Room for the widest value, so that nothing jumps while the numbers run.
  indentation_ = add_figure(row, "indentation", "INDENTATION", "000.0 µm");
  force_ = add_figure(row, "force", "FORCE OF THE NEEDLE", "0.00 µN", "95 %: 00.00 – 00.00 µN");
  pressure_ = add_figure(row, "pressure", "PRESSURE", "0000 Pa");
  confidence_ = add_figure(row, "confidence", "CONFIDENCE", "100 %");
  row->addStretch(1);
  profile_ = add_figure(row, "profile", "CELL PROFILE", "");
}

ReadoutBar::Figure ReadoutBar::add_figure(QHBoxLayout* row, const char* name, const char* heading, const char* widest,
                                          const char* widest_note) {
  auto* box = new QVBoxLayout;
  box->setSpacing(0);
  auto* title = new QLabel(heading, this);
  title->setObjectName("readoutName");
  box->addWidget(title);

  Figure figure;
  figure.value = new QLabel(this);
  figure.value->setObjectName(name);
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
    figure.note->setObjectName(QString(name) + "Note");
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

// A narrow window keeps its figures whole.
void ReadoutBar::resizeEvent(QResizeEvent*) {
  layout()->setSpacing(width() < kRoomy_px ? 14 : 34);
}

void ReadoutBar::show_texts(const ReadoutTexts& texts) {
  state_->setText(QString::fromStdString(texts.state.text));
  state_->setStyleSheet("background: " + QString::fromStdString(texts.state.color.css()));
  show_phrase(*indentation_.value, texts.indentation);
  show_phrase(*force_.value, texts.force);
  show_phrase(*force_.note, texts.force_note);
  for (QLabel* label : {force_.value, force_.note}) label->setToolTip(QString::fromStdString(texts.force_tip));
  show_phrase(*pressure_.value, texts.pressure);
  show_phrase(*confidence_.value, texts.confidence);
  show_phrase(*profile_.value, texts.profile);
  profile_.value->setToolTip(QString::fromStdString(texts.profile_tip));
}

}  // namespace pellucida
