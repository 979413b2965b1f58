#include "widgets/Panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include "WindowMemory.h"
#include "widgets/ButtonKey.h"
#include "widgets/KeySheet.h"

namespace pellucida {

Panel::Panel(const QString& title, QWidget* content, QWidget* parent) : QFrame(parent) {
  set_key_group(*this, title);
  auto* head = new QWidget(this);
  head->setObjectName("panelHead");
  head->setAttribute(Qt::WA_StyledBackground);
  head->setFixedHeight(36);
  head_ = new QHBoxLayout(head);
  head_->setContentsMargins(12, 0, 6, 0);
  head_->setSpacing(4);
  title_ = new QLabel(title, head);
  title_->setObjectName("panelTitle");
  head_->addWidget(title_);
  head_->addStretch(1);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(head);
  column->addWidget(content, 1);
}

void Panel::resizeEvent(QResizeEvent*) {
  const QMargins margins = head_->contentsMargins();
  int needed_px = margins.left() + margins.right() + title_->sizeHint().width();
  for (int i = 0; i < head_->count(); ++i) {
    const QWidget* control = head_->itemAt(i)->widget();
    if (control && control != title_) needed_px += head_->spacing() + control->sizeHint().width();
  }
  title_->setVisible(needed_px <= width());
}

void Panel::add_control(QWidget* control) {
  control->setParent(this);
  head_->addWidget(control);
}

void Panel::lead_with(QWidget* control) {
  control->setParent(this);
  head_->insertWidget(0, control);
}

QToolButton* Panel::add_toggle(const QString& text, const QString& tip, const QKeySequence& key, bool on) {
  QToolButton* button = add_button(text, tip, key);
  button->setCheckable(true);
  button->setChecked(on);
  // A toggle's key is its own in the window, whatever the language.
  keep_as(*button, "toggle_" + key.toString(QKeySequence::PortableText));
  return button;
}

QToolButton* Panel::add_button(const QString& text, const QString& tip, const QKeySequence& key) {
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setToolTip(tip);
  if (!key.isEmpty()) bind_key(*button, key, tip);
  button->setProperty("flat", true);
  button->setFocusPolicy(Qt::TabFocus);
  head_->addWidget(button);
  return button;
}

}  // namespace pellucida
