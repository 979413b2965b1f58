#include "widgets/LessonCard.h"

#include <QCheckBox>
#include <QListWidget>

#include "Words.h"
#include "widgets/CardFields.h"

namespace pellucida {
namespace {

constexpr int kLessonRow_px = 25;

}  // namespace

LessonCard::LessonCard(const StartForm& form, std::function<void()> start)
    : StartCard({StartCardId::kLesson, Pictogram::kLesson, words("Learn"),
                 words("A cell to poke on screen, with lessons on how its force comes about."), words("Begin")},
                start),
      lessons_(lesson_entries()) {
  list_ = new QListWidget;
  for (const auto& lesson : lessons_) {
    auto* item = new QListWidgetItem(QString::fromStdString(lesson.title), list_);
    item->setToolTip(QString::fromStdString(lesson.detail));
  }
  list_->setCurrentRow(index_of(lessons_, form.lesson));
  list_->setTabKeyNavigation(false);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setFixedHeight(kLessonRow_px * std::clamp(list_->count(), 1, 12) + 6);
  add_field(words("Lesson"), list_, "lessons");
  connect(list_, &QListWidget::itemDoubleClicked, this, std::move(start));
  large_ = new QCheckBox(words("Large letters"));
  large_->setObjectName("largeLetters");
  large_->setChecked(form.large_letters);
  add_widget(large_);
  finish();
}

void LessonCard::write(StartForm& form) const {
  form.lesson = list_->currentRow() < 0 ? "" : lessons_[static_cast<std::size_t>(list_->currentRow())].value;
  form.large_letters = large_->isChecked();
}

}  // namespace pellucida
