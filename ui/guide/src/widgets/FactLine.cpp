#include "widgets/FactLine.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVariant>

#include "Words.h"
#include "presenters/ReadoutPresenter.h"
#include "presenters/ScalePresenter.h"
#include "widgets/Figure.h"
#include "widgets/PhraseLabel.h"
#include "widgets/ScaleGauge.h"
#include "widgets/StatePill.h"

namespace pellucida {
namespace {

// From this width on there is room for what the tips say too.
constexpr int kRoomForParts_px = 1300;
constexpr int kRoomForPressure_px = 1150;

}  // namespace

FactLine::FactLine(QWidget* parent) : QFrame(parent) {
  setObjectName("factLine");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(38);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 0, 16, 6);
  row->setSpacing(6);
  row->addWidget(state_ = new StatePill(this));
  row->addSpacing(8);
  puncture_name_ = new QLabel(words("PUNCTURE"), this);
  puncture_name_->setObjectName("readoutName");
  row->addWidget(puncture_name_);
  row->addWidget(puncture_ = new QLabel(this));
  puncture_->setObjectName("puncture");
  puncture_->setProperty("fact", true);
  puncture_->setProperty("kept", true);
  puncture_->setToolTip(
      words("The last puncture: largest force before it, depth and work of the needle up to it. Stays until "
            "the next cell."));
  parts_ = new FigureLabel(words("picture ±00 %, kind of cell ±00 %"), this);
  parts_->setObjectName("forceParts");
  parts_->setProperty("figureNote", true);
  row->addWidget(parts_);
  row->addStretch(1);
  pressure_ = add_fact("pressure", words("PRESSURE"), words("0000 Pa"));
  confidence_ = add_fact("confidence", words("CONFIDENCE"), "100 %");
  pressure_->setToolTip(words(kPressureTip));
  confidence_->setToolTip(words(kConfidenceTip));
  scale_ = add_fact("scale", words("SCALE"), "±00 %");
  row->addWidget(gauge_ = new ScaleGauge(this));
  gauge_->setFixedWidth(96);
  profile_ = add_fact("profile", "", "");
  show_puncture({});
}

QLabel* FactLine::add_fact(const char* key, const QString& name, const QString& widest) {
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->addSpacing(8);
  if (!name.isEmpty()) {
    auto* heading = new QLabel(name, this);
    heading->setObjectName("readoutName");
    row->addWidget(heading);
    if (qstrcmp(key, "pressure") == 0) pressure_name_ = heading;
  }
  auto* value = new FigureLabel(widest, this);
  value->setObjectName(key);
  value->setProperty("fact", true);
  row->addWidget(value);
  return value;
}

void FactLine::resizeEvent(QResizeEvent*) {
  parts_->setVisible(width() >= kRoomForParts_px);
  // The curve of a narrow window tells of the touch; what stays of a puncture is seen nowhere else.
  const bool has_room = width() >= kRoomForPressure_px || puncture_->text().isEmpty();
  pressure_name_->setVisible(has_room);
  pressure_->setVisible(has_room);
  // Without room for all, the puncture's numbers come before its heading.
  puncture_name_->setVisible(!puncture_->text().isEmpty());
  if (layout()->minimumSize().width() > width()) puncture_name_->hide();
}

void FactLine::show_texts(const ReadoutTexts& texts) {
  state_->show_state(texts.state);
  show_phrase(*parts_, texts.force_parts);
  parts_->setToolTip(QString::fromStdString(texts.force_tip));
  show_phrase(*pressure_, texts.pressure);
  show_phrase(*confidence_, texts.confidence);
  show_phrase(*profile_, texts.profile);
  profile_->setToolTip(QString::fromStdString(texts.profile_tip));
}

void FactLine::show_scale(const ScaleTexts& texts) {
  show_phrase(*scale_, texts.text);
  scale_->setToolTip(QString::fromStdString(texts.tip));
  gauge_->show_scale(texts);
}

void FactLine::show_puncture(const QString& text) {
  const bool changed = puncture_->text() != text;
  puncture_->setText(text);
  puncture_->setVisible(!text.isEmpty());
  if (changed) resizeEvent(nullptr);
}

}  // namespace pellucida
