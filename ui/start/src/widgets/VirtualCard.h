#pragma once
#include <vector>

#include "presenters/StartLists.h"
#include "widgets/StartCard.h"

namespace pellucida {

class Choice;

/// The virtual microscope: scenario, stiffness of the cell, and hand.
class VirtualCard final : public StartCard {
 public:
  VirtualCard(const StartForm& form, std::function<void()> start);

  void write(StartForm& form) const override;
  using StartCard::show_problem;
  bool show_problem(const StartProblem&) override { return false; }
  void clear_problems() override {}

 private:
  void show_details();

  std::vector<StartEntry> scenarios_;
  std::vector<StartEntry> stiffnesses_;
  std::vector<StartEntry> hands_;
  Choice* scenario_;
  Choice* stiffness_;
  Choice* hand_;
  CardField* scenario_field_;
  CardField* stiffness_field_;
  CardField* hand_field_;
};

}  // namespace pellucida
