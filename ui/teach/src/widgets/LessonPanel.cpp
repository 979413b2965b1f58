#include "widgets/LessonPanel.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>

#include "Words.h"
#include "pellucida/core/Html.h"

namespace pellucida {
namespace {

QString html_of(const std::string& text) {
  return QString::fromStdString(html_text(text));
}

}  // namespace

LessonPanel::LessonPanel(std::vector<Lesson> lessons, std::function<void(const Lesson&)> opened, QWidget* parent)
    : QWidget(parent), lessons_(std::move(lessons)), done_(lessons_.size(), false), opened_(std::move(opened)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  list_ = new QListWidget(this);
  list_->setObjectName("lessons");
  list_->setAccessibleName(words("Lessons"));
  list_->setFocusPolicy(Qt::TabFocus);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  for (std::size_t k = 0; k < lessons_.size(); ++k) list_->addItem(QString());
  show_titles();
  column->addWidget(list_);
  scroll_ = new QScrollArea(this);
  scroll_->setWidgetResizable(true);
  scroll_->setAccessibleName(words("The lesson's page"));
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(scroll_, 1);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) { open(row); });
}

void LessonPanel::show_titles() {
  for (int k = 0; k < count(); ++k) {
    const QString mark = is_done(k) ? QString::fromUtf8("\u2713 ") : QString();
    list_->item(k)->setText(
        QString("%1  %2%3").arg(k + 1).arg(mark, QString::fromStdString(lessons_[static_cast<std::size_t>(k)].title)));
  }
}

// All titles, whatever the letters.
void LessonPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) fit_list();
}
void LessonPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  fit_list();
}
void LessonPanel::fit_list() {
  list_->ensurePolished();
  list_->setFixedHeight(count() * list_->sizeHintForRow(0) + 2 * list_->frameWidth() + 2);
}

void LessonPanel::open(int index) {
  if (index < 0 || index >= count()) return;
  current_ = index;
  const QSignalBlocker quiet(list_);
  list_->setCurrentRow(index);
  const Lesson& lesson = lessons_[static_cast<std::size_t>(index)];
  build_page(lesson);
  opened_(lesson);
}

QLabel* LessonPanel::add_text(const QString& html, const char* object_name) {
  auto* label = new QLabel(html);
  label->setObjectName(object_name);
  label->setTextFormat(Qt::RichText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::NoTextInteraction);
  page_->addWidget(label);
  return label;
}

void LessonPanel::add_list(const QString& head, const std::vector<std::string>& points, bool numbered) {
  add_text(head, "lessonHead");
  int number = 0;
  for (const std::string& point : points) {
    const QString mark = numbered ? QString("%1.").arg(++number) : QString::fromUtf8("\u2022");
    add_text(QString("<table cellspacing=0><tr><td width=20>%1</td><td>%2</td></tr></table>").arg(mark, html_of(point)),
             "lessonText");
  }
}

void LessonPanel::build_page(const Lesson& lesson) {
  auto* page = new QWidget;
  page->setObjectName("page");
  page_ = new QVBoxLayout(page);
  page_->setContentsMargins(14, 12, 14, 16);
  page_->setSpacing(8);
  add_text(html_of(lesson.title), "lessonTitle");
  for (const std::string& paragraph : lesson.text) add_text(html_of(paragraph), "lessonText");
  add_list(words("DO"), lesson.to_do, true);
  add_list(words("OBSERVE"), lesson.observe, false);

  if (!lesson.scenario.empty()) {
    add_text(words("In the virtual microscope: scenario %1").arg(html_of(lesson.scenario)), "parameterNote");
  }
  add_text(words("QUESTION"), "lessonHead");
  add_text(html_of(lesson.question), "lessonText");
  auto* choices = new QButtonGroup(page);
  for (std::size_t k = 0; k < lesson.answers.size(); ++k) {
    // A button can't break its text into lines; the label beside it can, and clicks it.
    auto* row = new QHBoxLayout;
    auto* button = new QRadioButton;
    button->setObjectName(QString("answer%1").arg(k));
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(QString::fromStdString(lesson.answers[k].text));
    auto* text = new QLabel(html_of(lesson.answers[k].text));
    text->setObjectName("lessonText");
    text->setWordWrap(true);
    text->setBuddy(button);
    row->addWidget(button, 0, Qt::AlignTop);
    row->addWidget(text, 1);
    page_->addLayout(row);
    choices->addButton(button, static_cast<int>(k));
  }
  verdict_ = add_text("", "wrongAnswer");
  connect(choices, &QButtonGroup::idClicked, this, [this](int choice) { answer(choice); });
  auto* again = new QPushButton(words("Set up again"));
  again->setFixedHeight(30);
  again->setToolTip(words("The lesson's parameters, and the cell at rest"));
  again->setFocusPolicy(Qt::TabFocus);
  page_->addWidget(again);
  connect(again, &QPushButton::clicked, this, [this] { opened_(lessons_[static_cast<std::size_t>(current_)]); });
  page_->addStretch(1);
  scroll_->setWidget(page);
  // A page made anew would come last in the window's order.
  QWidget* before = list_;
  for (QAbstractButton* button : choices->buttons()) {
    setTabOrder(before, button);
    before = button;
  }
  setTabOrder(before, again);
  scroll_->verticalScrollBar()->setValue(0);
}

void LessonPanel::answer(int choice) {
  const LessonAnswer& given = lessons_[static_cast<std::size_t>(current_)].answers[static_cast<std::size_t>(choice)];
  verdict_->setObjectName(given.is_right ? "rightAnswer" : "wrongAnswer");
  verdict_->setText((given.is_right ? words("Right. ") : words("No. ")) + html_of(given.explanation));
  verdict_->style()->unpolish(verdict_);
  verdict_->style()->polish(verdict_);
  if (given.is_right) done_[static_cast<std::size_t>(current_)] = true;
  show_titles();
}

}  // namespace pellucida
