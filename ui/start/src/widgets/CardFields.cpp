#include "widgets/CardFields.h"

#include <QAbstractItemView>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "Words.h"
#include "presenters/PixelMeasure.h"
#include "widgets/Choice.h"

namespace pellucida {
namespace {

constexpr int kControlHeight_px = 28;

QLabel* add_line(QVBoxLayout& column, const char* object_name) {
  auto* label = new QLabel;
  label->setObjectName(object_name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->hide();
  column.addWidget(label);
  return label;
}

void show_line(QLabel& label, const std::string& text) {
  label.setText(QString::fromStdString(text));
  label.setVisible(!text.empty());
}

}  // namespace

CardField::CardField(const QString& name, QWidget* control, const char* object_name) : control_(control) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(3);
  auto* caption = new QLabel(name);
  caption->setObjectName("fieldName");
  caption->setWordWrap(true);
  column->addWidget(caption);
  control->setObjectName(object_name);
  control->setAccessibleName(name);
  caption->setBuddy(control);
  column->addWidget(control);
  note_ = add_line(*column, "fieldNote");
  problem_ = add_line(*column, "fieldProblem");
}

void CardField::show_note(const std::string& text) {
  show_line(*note_, text);
}

void CardField::show_problem(const std::string& text) {
  show_line(*problem_, text);
  // Read to those who can't see the line below.
  control_->setAccessibleDescription(problem_->text());
}

Choice* make_choice(const std::vector<StartEntry>& entries, const std::string& chosen) {
  auto* choice = new Choice;
  choice->setFixedHeight(kControlHeight_px);
  choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice->setMinimumContentsLength(8);
  for (const auto& entry : entries) {
    choice->addItem(QString::fromStdString(entry.title), QString::fromStdString(entry.value));
    choice->setItemData(choice->count() - 1, QString::fromStdString(entry.detail), Qt::ToolTipRole);
  }
  if (!entries.empty()) choice->setCurrentIndex(index_of(entries, chosen));
  choice->view()->setTextElideMode(Qt::ElideRight);
  return choice;
}

std::string value_of(const Choice& choice) {
  return choice.currentData().toString().toStdString();
}

QLineEdit* make_number_line(const QString& unit, const QString& placeholder, const std::string& text) {
  auto* line = new QLineEdit(QString::fromStdString(text));
  line->setFixedHeight(kControlHeight_px);
  line->setPlaceholderText(placeholder);
  // A file dropped here is dropped on the window.
  line->setAcceptDrops(false);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 9, 0);
  row->addStretch(1);
  auto* label = new QLabel(unit, line);
  label->setObjectName("fieldUnit");
  label->setAttribute(Qt::WA_TransparentForMouseEvents);
  row->addWidget(label);
  const auto dim_while_empty = [line] {
    line->setProperty("blank", line->text().isEmpty());
    line->style()->unpolish(line);
    line->style()->polish(line);
  };
  QObject::connect(line, &QLineEdit::textChanged, line, dim_while_empty);
  dim_while_empty();
  line->setTextMargins(0, 0, label->sizeHint().width() + 8, 0);
  return line;
}

QPushButton* make_measure_button() {
  auto* button = new QPushButton(words("Measure on the image ..."));
  button->setObjectName("measurePixel");
  button->setFixedHeight(kControlHeight_px);
  button->setToolTip(words("By a scale bar, or a needle of known diameter"));
  return button;
}

std::string measured_note(const PixelMeasure& measure) {
  return words("Measured: %1").arg(QString::fromStdString(measure.text)).toStdString();
}

}  // namespace pellucida
