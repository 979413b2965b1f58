#include "widgets/VirtualCard.h"

#include "Words.h"
#include "widgets/CardFields.h"
#include "widgets/Choice.h"

namespace pellucida {

VirtualCard::VirtualCard(const StartForm& form, std::function<void()> start)
    : StartCard({StartCardId::kVirtual, Pictogram::kProgram, words("Try the virtual microscope"),
                 words("A simulated cell under a simulated microscope. Nothing has to be connected."), words("Start")},
                std::move(start)),
      scenarios_(scenario_entries()),
      stiffnesses_(stiffness_entries()),
      hands_(hand_entries()) {
  scenario_field_ = add_field(words("Scenario"), scenario_ = make_choice(scenarios_, form.scenario), "scenario");
  stiffness_field_ =
      add_field(words("Stiffness of the cell"), stiffness_ = make_choice(stiffnesses_, form.stiffness), "stiffness");
  hand_field_ = add_field(words("What moves the needle"), hand_ = make_choice(hands_, form.hand), "hand");
  finish();
  for (Choice* choice : {scenario_, stiffness_, hand_}) {
    connect(choice, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { show_details(); });
  }
  show_details();
}

void VirtualCard::write(StartForm& form) const {
  form.scenario = value_of(*scenario_);
  form.stiffness = value_of(*stiffness_);
  form.hand = value_of(*hand_);
}

void VirtualCard::show_details() {
  scenario_field_->show_note(scenarios_[static_cast<std::size_t>(scenario_->currentIndex())].detail);
  stiffness_field_->show_note(stiffnesses_[static_cast<std::size_t>(stiffness_->currentIndex())].detail);
  hand_field_->show_note(hands_[static_cast<std::size_t>(hand_->currentIndex())].detail);
}

}  // namespace pellucida
