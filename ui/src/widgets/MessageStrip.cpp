#include "widgets/MessageStrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVariant>

namespace pellucida {

MessageStrip::MessageStrip(const char* key, std::initializer_list<Button> answers, QWidget* parent) : QFrame(parent) {
  setObjectName(key);
  setProperty("message", true);
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 7, 16, 7);
  row->setSpacing(10);
  text_ = new QLabel(this);
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(text_, 1);
  for (const Button& answer : answers) {
    auto* button = new QPushButton(answer.first, this);
    button->setFixedHeight(30);
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QPushButton::clicked, this, [this, act = answer.second] {
      hide();
      if (act) act();
    });
    row->addWidget(button);
  }
  hide();
}

void MessageStrip::say_text(const QString& text) {
  text_->setText(text);
  setAccessibleName(text);
  show();
}

QString MessageStrip::text() const {
  return text_->text();
}

}  // namespace pellucida
