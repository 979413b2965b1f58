#include "widgets/ReadoutBar.h"

#include <QHBoxLayout>
#include <QLabel>

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
  indentation_ = add_figure(*row, *this, "indentation", "INDENTATION", "000.0 µm");
  force_ = add_figure(*row, *this, "force", "FORCE OF THE NEEDLE", "0.00 µN", "95 %: 00.00 – 00.00 µN");
  pressure_ = add_figure(*row, *this, "pressure", "PRESSURE", "0000 Pa");
  confidence_ = add_figure(*row, *this, "confidence", "CONFIDENCE", "100 %");
  row->addStretch(1);
  profile_ = add_figure(*row, *this, "profile", "CELL PROFILE", "");
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
