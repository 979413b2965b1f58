#include "widgets/StatusLine.h"

#include <QHBoxLayout>
#include <QLabel>

#include "Words.h"
#include "presenters/StatusPresenter.h"
#include "widgets/BlockLabel.h"
#include "widgets/PhraseLabel.h"

namespace pellucida {

StatusLine::StatusLine(QWidget* parent) : QWidget(parent) {
  setObjectName("statusLine");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(30);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 16, 0);
  row->setSpacing(24);
  // Room for the widest text, so that nothing jumps.
  frame_age_ = add_phrase_label(*row, words("Frame age 0000 ms"));
  frame_rate_ = add_phrase_label(*row, words("Frames/s: 000.0 measured, 000.0 drawn"));
  lost_ = add_phrase_label(*row, words("00000 frames skipped"));
  frame_age_->setToolTip(words("From a frame's arrival to its force on screen"));
  frame_rate_->setToolTip(words("Frames a second that were measured, and that this window has drawn"));
  lost_->setToolTip(words("Frames that were not measured, that the source lost, or that are recorded in part"));
  notice_ = add_phrase_label(*row);
  notice_->setObjectName("notice");
  notice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addStretch(1);
  row->addWidget(new BlockLabel(this));
  recording_ = add_phrase_label(*row);
  recording_->setTextInteractionFlags(Qt::TextSelectableByMouse);
}

void StatusLine::show_texts(const StatusTexts& texts) {
  show_phrase(*frame_age_, texts.frame_age);
  show_phrase(*frame_rate_, texts.frame_rate);
  show_phrase(*lost_, texts.lost);
  show_phrase(*recording_, texts.recording);
}

void StatusLine::show_notice(const Phrase& phrase) {
  show_phrase(*notice_, phrase);
}

}  // namespace pellucida
