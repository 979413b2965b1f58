#include "widgets/RecordStrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QVariant>

#include "Words.h"

namespace pellucida {
namespace {

constexpr int kLongestName = 80, kLongestText = 1000;

}  // namespace

RecordStrip::RecordStrip(Actions actions, QWidget* parent) : QFrame(parent) {
  setObjectName("recordStrip");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(42);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 5, 16, 5);
  row->setSpacing(8);
  name_ = add_field("cellName", words("Cell"), words("Name; Enter takes it"), 1);
  note_ = add_field("noteText", words("Note"), words("A remark for the session's events; Enter writes it"), 3);
  connect(name_, &QLineEdit::returnPressed, this, [this, take = std::move(actions.name)] {
    const QString name = name_->text().trimmed();
    if (!name.isEmpty()) take(name);
    leave(*name_);
  });
  connect(note_, &QLineEdit::returnPressed, this, [this, take = std::move(actions.note)] {
    const QString text = note_->text().trimmed();
    if (!text.isEmpty()) take(text);
    note_->clear();
    leave(*note_);
  });
  auto* close = new QPushButton(QString::fromUtf8("\u2715"), this);
  close->setProperty("narrow", true);
  close->setFixedSize(28, 28);
  close->setToolTip(words("Close: nothing typed is kept"));
  close->setAccessibleName(words("Close"));
  close->setFocusPolicy(Qt::TabFocus);
  connect(close, &QPushButton::clicked, this, [this] {
    note_->clear();
    hide();
  });
  row->addWidget(close);
  hide();
}

QLineEdit* RecordStrip::add_field(const char* key, const QString& name, const QString& hint, int stretch) {
  auto* row = static_cast<QHBoxLayout*>(layout());
  auto* heading = new QLabel(name, this);
  heading->setObjectName("noteWhere");
  row->addWidget(heading);
  auto* field = new QLineEdit(this);
  field->setObjectName(key);
  field->setProperty("typed", true);
  field->setMaxLength(stretch == 1 ? kLongestName : kLongestText);
  field->setPlaceholderText(hint);
  field->setToolTip(hint);
  field->setAccessibleName(name);
  field->setFocusPolicy(Qt::StrongFocus);
  // What is only a hint is written fainter.
  const auto follow = [field](const QString& text) {
    field->setProperty("blank", text.isEmpty());
    field->style()->polish(field);
  };
  connect(field, &QLineEdit::textChanged, field, follow);
  follow({});
  heading->setBuddy(field);
  row->addWidget(field, stretch);
  return field;
}

void RecordStrip::offer_name(const QString& name, bool is_given) {
  name_->setToolTip(is_given ? words("Name of the cell in view") : words("Suggested: Enter takes it"));
  if (!name_->hasFocus()) name_->setText(name);
}

void RecordStrip::begin_name() {
  show();
  name_->setFocus(Qt::ShortcutFocusReason);
  name_->selectAll();
}

void RecordStrip::begin_note() {
  show();
  note_->setFocus(Qt::ShortcutFocusReason);
}

void RecordStrip::leave(QLineEdit& field) {
  field.clearFocus();
}

}  // namespace pellucida
