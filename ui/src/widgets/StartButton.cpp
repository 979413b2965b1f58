#include "widgets/StartButton.h"

#include <QKeySequence>
#include <QPushButton>

#include "Closing.h"
#include "Words.h"
#include "widgets/ButtonKey.h"
#include "widgets/Icons.h"

namespace pellucida {

QPushButton* make_start_button(QWidget* parent) {
  auto* button = new QPushButton(parent);
  button->setObjectName("startPage");
  button->setIcon(make_icon(Pictogram::kHome));
  button->setAccessibleName(words("Start page"));
  button->setFixedSize(34, 30);
  button->setFocusPolicy(Qt::TabFocus);
  bind_key(*button, QKeySequence("Alt+Home"), words("Start page: choose another source, session or lesson"));
  QObject::connect(button, &QPushButton::clicked, button, [button] { close_for_start_page(*button->window()); });
  return button;
}

}  // namespace pellucida
