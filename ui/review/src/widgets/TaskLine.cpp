#include "widgets/TaskLine.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "Words.h"
#include "presenters/Phrase.h"
#include "widgets/PhraseLabel.h"

namespace pellucida {

TaskLine::TaskLine(std::function<void()> cancel, QWidget* parent) : QWidget(parent) {
  setObjectName("statusLine");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(30);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 16, 0);
  row->setSpacing(10);
  notice_ = add_phrase_label(*row);
  notice_->setObjectName("notice");
  notice_->setTextFormat(Qt::PlainText);
  notice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // A long line is cut off rather than widening the window.
  notice_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->setStretch(0, 1);
  work_ = add_phrase_label(*row);
  work_->setTextFormat(Qt::PlainText);
  progress_ = new QProgressBar;
  progress_->setTextVisible(false);
  progress_->setFixedSize(140, 8);
  row->addWidget(progress_);
  auto* button = new QPushButton(words("Cancel"));
  button->setObjectName("cancelWork");
  button->setFixedHeight(22);
  button->setFocusPolicy(Qt::TabFocus);
  connect(button, &QPushButton::clicked, this, std::move(cancel));
  row->addWidget(button);
  cancel_ = button;
  show_work({}, 0, 0);
}

void TaskLine::show_notice(const Phrase& phrase) {
  show_phrase(*notice_, phrase);
  notice_->setToolTip(phrase.text.empty() ? QString()
                                          : "<p>" + QString::fromStdString(phrase.text).toHtmlEscaped() + "</p>");
}

void TaskLine::show_work(const QString& text, std::size_t done, std::size_t all) {
  const bool working = !text.isEmpty();
  for (QWidget* part : {static_cast<QWidget*>(work_), static_cast<QWidget*>(progress_), cancel_}) {
    part->setVisible(working);
  }
  if (!working) return;
  work_->setText(text);
  progress_->setRange(0, static_cast<int>(all));
  progress_->setValue(static_cast<int>(done));
}

}  // namespace pellucida
