#pragma once
#include <vector>

#include "presenters/StartLists.h"
#include "widgets/StartCard.h"

class QCheckBox;
class QListWidget;

namespace pellucida {

/// The lessons of Teach mode, and how it looks.
class LessonCard final : public StartCard {
 public:
  LessonCard(const StartForm& form, std::function<void()> start);

  void write(StartForm& form) const override;
  using StartCard::show_problem;
  bool show_problem(const StartProblem&) override { return false; }
  void clear_problems() override {}

 private:
  std::vector<StartEntry> lessons_;
  QListWidget* list_;
  QCheckBox* large_;
};

}  // namespace pellucida
