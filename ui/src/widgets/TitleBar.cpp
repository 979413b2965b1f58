#include "widgets/TitleBar.h"

#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QPushButton>

#include "widgets/BlockLabel.h"
#include "widgets/ButtonKey.h"
#include "widgets/ElidedLabel.h"
#include "widgets/Icons.h"
#include "widgets/KeySheet.h"
#include "widgets/LookMenu.h"
#include "widgets/StartButton.h"

namespace pellucida {
TitleBar::TitleBar(QWidget* parent) : QWidget(parent) {
  setObjectName("topBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(46);
  row_ = new QHBoxLayout(this);
  row_->setContentsMargins(16, 0, 16, 0);
  row_->setSpacing(8);
  auto* mark = new QLabel(this);
  mark->setPixmap(make_icon(Pictogram::kProgram).pixmap(22, 22));
  row_->addWidget(mark);
  auto* brand = new QLabel("Pellucida", this);
  brand->setObjectName("brand");
  row_->addWidget(brand);
  row_->addSpacing(18);
}

QPushButton* TitleBar::add_button(const QString& text, const QKeySequence& key, const QString& tip,
                                  std::function<void()> action) {
  QPushButton* button = add_menu_button(text, tip);
  bind_key(*button, key, tip);
  if (action) connect(button, &QPushButton::clicked, this, std::move(action));
  return button;
}

QPushButton* TitleBar::add_menu_button(const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, this);
  button->setFixedHeight(30);
  button->setFocusPolicy(Qt::TabFocus);
  button->setToolTip(tip);
  row_->addWidget(button);
  return button;
}

void TitleBar::add_start_button() {
  row_->addWidget(make_start_button(this));
}

void TitleBar::add_look_menu(const QKeySequence& light_key) {
  row_->addWidget(make_look_button(light_key, this));
  row_->addWidget(make_keys_button(this));
}

void TitleBar::add_name(const QString& name, const QString& tip, bool shows_blocks) {
  row_->addStretch(1);
  if (shows_blocks) row_->addWidget(new BlockLabel(this));
  auto* label = new ElidedLabel(Qt::ElideMiddle, this);
  label->setText(name);
  label->setObjectName("sourceName");
  label->setToolTip(tip.isEmpty() || tip == name ? name : name + "\n" + tip);
  row_->addWidget(label);
}

}  // namespace pellucida
