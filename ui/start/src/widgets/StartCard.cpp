#include "widgets/StartCard.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>
#include <QVariant>

#include "Words.h"
#include "widgets/CardFields.h"

namespace pellucida {
namespace {

constexpr int kIcon_px = 26;
constexpr int kMargin_px = 14;
constexpr int kScrollBar_px = 10;

}  // namespace

StartCard::StartCard(const Look& look, std::function<void()> start) : id_(look.id) {
  setObjectName("startCard");
  setAccessibleName(look.title);
  setFocusPolicy(Qt::StrongFocus);
  auto* column = new QVBoxLayout(this);
  // The scroll bar of the fields has its place in the right margin.
  column->setContentsMargins(kMargin_px, kMargin_px, kMargin_px - kScrollBar_px, kMargin_px);
  column->setSpacing(8);
  head_ = new QWidget;
  auto* head_column = new QVBoxLayout(head_);
  head_column->setContentsMargins(0, 0, kScrollBar_px, 0);
  head_column->setSpacing(6);
  auto* head = new QHBoxLayout;
  head->setSpacing(10);
  auto* icon = new QLabel;
  icon->setPixmap(make_icon(look.icon).pixmap(kIcon_px, kIcon_px));
  icon->setFixedWidth(kIcon_px);
  head->addWidget(icon, 0, Qt::AlignTop);
  auto* title = new QLabel(look.title);
  title->setObjectName("cardTitle");
  title->setWordWrap(true);
  head->addWidget(title, 1);
  auto* number = new QLabel(QString::number(static_cast<int>(id_) + 1));
  number->setObjectName("cardNumber");
  number->setToolTip(words("Press %1 to choose this card").arg(static_cast<int>(id_) + 1));
  head->addWidget(number, 0, Qt::AlignTop);
  head_column->addLayout(head);
  auto* sentence = new QLabel(look.sentence);
  sentence->setObjectName("cardText");
  sentence->setWordWrap(true);
  head_column->addWidget(sentence);
  head_column->addStretch(1);
  column->addWidget(head_);

  fields_ = new QWidget;
  fields_->setObjectName("cardFields");
  column_ = new QVBoxLayout(fields_);
  column_->setContentsMargins(0, 2, kScrollBar_px, 2);
  column_->setSpacing(9);
  scroll_ = new QScrollArea;
  scroll_->setWidget(fields_);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  column->addWidget(scroll_, 1);

  problem_ = new QLabel;
  problem_->setObjectName("cardProblem");
  problem_->setTextFormat(Qt::PlainText);
  problem_->setWordWrap(true);
  problem_->hide();
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(0, 0, kScrollBar_px, 0);
  foot->addWidget(problem_);
  start_ = new QPushButton(look.button);
  start_->setObjectName("startRun");
  start_->setAccessibleName(QString("%1: %2").arg(look.title, look.button));
  start_->setFixedHeight(34);
  connect(start_, &QPushButton::clicked, this, std::move(start));
  foot->addWidget(start_);
  column->addLayout(foot);
}

void StartCard::show_current(bool current) {
  if (property("current").toBool() == current) return;
  setProperty("current", current);
  for (QWidget* widget : {static_cast<QWidget*>(this), static_cast<QWidget*>(start_)}) {
    style()->unpolish(widget);
    style()->polish(widget);
  }
}

void StartCard::show_problem(const std::string& text) {
  problem_->setText(QString::fromStdString(text));
  problem_->setVisible(!text.empty());
}

int StartCard::head_height_px() const {
  const int width_px = width() - 2 * kMargin_px + kScrollBar_px;
  return head_->layout()->hasHeightForWidth() ? head_->layout()->heightForWidth(width_px) : head_->sizeHint().height();
}

void StartCard::set_head_height(int height_px) {
  head_->setFixedHeight(height_px);
}

bool StartCard::point_at(CardField* field, const std::string& text) {
  if (!field) return false;
  field->show_problem(text);
  field->control().setFocus(Qt::OtherFocusReason);
  // Once the sentence has its place.
  QTimer::singleShot(0, field, [this, field] { scroll_->ensureWidgetVisible(field, 0, 0); });
  return true;
}

CardField* StartCard::add_field(const QString& name, QWidget* control, const char* object_name) {
  auto* field = new CardField(name, control, object_name);
  column_->addWidget(field);
  return field;
}

void StartCard::add_widget(QWidget* widget) {
  column_->addWidget(widget);
}

void StartCard::finish() {
  column_->addStretch(1);
  QWidget* before = this;
  for (QWidget* widget : fields_->findChildren<QWidget*>()) {
    // Not what lies in the popup of a list.
    if ((widget->focusPolicy() & Qt::TabFocus) == 0 || widget->window() != window()) continue;
    setTabOrder(before, widget);
    before = widget;
  }
  setTabOrder(before, start_);
}

}  // namespace pellucida
