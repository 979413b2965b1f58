#include "widgets/ReadoutBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "Theme.h"
#include "Words.h"
#include "presenters/ReadoutPresenter.h"
#include "presenters/ScalePresenter.h"
#include "widgets/PhraseLabel.h"
#include "widgets/ScaleGauge.h"
#include "widgets/StatePill.h"

namespace pellucida {
namespace {

// The width from which on there is room for words.
constexpr int kRoomy_px = 1300;

}  // namespace

ReadoutBar::ReadoutBar(QWidget* parent) : QFrame(parent) {
  setObjectName("readoutBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(66);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 6, 16, 8);

  row->addWidget(state_ = new StatePill(this));
  indentation_ = add_figure(*row, *this, "indentation", words("INDENTATION"), "000.0 µm");
  force_ = add_figure(*row, *this, "force", words("FORCE OF THE NEEDLE"), "0.00 µN", "95 %: 00.00 – 00.00 µN");
  force_.note->setContentsMargins(0, 0, 0, 0);  // two lines
  pressure_ = add_figure(*row, *this, "pressure", words("PRESSURE"), words("0000 Pa"));
  confidence_ = add_figure(*row, *this, "confidence", words("CONFIDENCE"), "100 %");
  indentation_.value->setToolTip(words(kIndentationTip));
  pressure_.value->setToolTip(words(kPressureTip));
  confidence_.value->setToolTip(words(kConfidenceTip));
  row->addLayout(build_scale());
  row->addStretch(1);
  profile_ = add_figure(*row, *this, "profile", words("CELL PROFILE"), "");
}

// The number beside its heading, the gauge below both.
QVBoxLayout* ReadoutBar::build_scale() {
  auto* box = new QVBoxLayout;
  box->setSpacing(0);
  auto* head = new QHBoxLayout;
  head->setSpacing(6);
  auto* heading = new QLabel(words("SCALE"), this);
  heading->setObjectName("readoutName");
  head->addWidget(heading);
  head->addWidget(scale_ = new FigureLabel("±00 %", this));
  scale_->setObjectName("scale");
  scale_->setProperty("smallFigure", true);
  head->addStretch(1);
  box->addLayout(head);
  box->addWidget(gauge_ = new ScaleGauge(this));
  return box;
}

// A narrow window keeps its figures whole.
void ReadoutBar::resizeEvent(QResizeEvent*) {
  const bool is_narrow = width() < kRoomy_px;
  layout()->setSpacing(is_narrow ? 9 : 24);
  layout()->setContentsMargins(is_narrow ? 10 : 16, 6, is_narrow ? 10 : 16, 8);
  gauge_->setFixedWidth(is_narrow ? 96 : 130);
  profile_.value->setProperty("smallFigure", is_narrow);
  profile_.value->style()->polish(profile_.value);
}

void ReadoutBar::show_scale(const ScaleTexts& texts) {
  show_phrase(*scale_, texts.text);
  scale_->setToolTip(QString::fromStdString(texts.tip));
  gauge_->show_scale(texts);
}

void ReadoutBar::show_texts(const ReadoutTexts& texts) {
  state_->show_state(texts.state);
  show_phrase(*indentation_.value, texts.indentation);
  show_phrase(*force_.value, texts.force);
  // The interval, and below it which of its parts opens it.
  Phrase note = texts.force_note;
  const bool is_narrow = width() < kRoomy_px;
  const std::string& parts = is_narrow ? texts.force_parts_short : texts.force_parts.text;
  if (!parts.empty()) note.text += "\n" + parts;
  show_phrase(*force_.note, note);
  for (QLabel* label : {force_.value, force_.note}) label->setToolTip(QString::fromStdString(texts.force_tip));
  show_phrase(*pressure_.value, texts.pressure);
  show_phrase(*confidence_.value, texts.confidence);
  show_phrase(*profile_.value, texts.profile);
  profile_.value->setToolTip(QString::fromStdString(texts.profile_tip));
  // A request for room that came while the bar was being shown is lost otherwise.
  layout()->activate();
}

}  // namespace pellucida
