#include "widgets/LessonCard.h"

#include <QCheckBox>
#include <QListWidget>

#include "widgets/CardFields.h"

namespace pellucida {
namespace {

constexpr int kLessonRow_px = 25;

}  // namespace

LessonCard::LessonCard(const StartForm& form, std::function<void()> start)
    : StartCard({StartCardId::kLesson, Pictogram::kLesson, "Learn",
                 "A cell to poke on screen, with lessons on how its force comes about.", "Begin"},
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
  list_->setFixedHeight(kLessonRow_px * std::clamp(list_->count(), 1, 8) + 6);
  add_field("Lesson", list_, "lessons");
  connect(list_, &QListWidget::itemDoubleClicked, this, std::move(start));
  light_ = new QCheckBox("Light theme, for projectors");
  light_->setObjectName("lightTheme");
  light_->setChecked(form.light_theme);
  add_widget(light_);
  large_ = new QCheckBox("Large letters");
  large_->setObjectName("largeLetters");
  large_->setChecked(form.large_letters);
  add_widget(large_);
  finish();
}

void LessonCard::write(StartForm& form) const {
  form.lesson = list_->currentRow() < 0 ? "" : lessons_[static_cast<std::size_t>(list_->currentRow())].value;
  form.light_theme = light_->isChecked();
  form.large_letters = large_->isChecked();
}

}  // namespace pellucida
