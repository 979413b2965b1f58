#include "DisplayControl.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QPushButton>

#include "EventSound.h"
#include "HandControl.h"
#include "WindowMemory.h"
#include "Words.h"
#include "pellucida/operation/OperatorConsole.h"
#include "pellucida/simulation/ModalityName.h"

namespace pellucida {
namespace {

bool has_space(Modality modality) {
  return modality != Modality::kFlatImage;
}
bool has_force(Modality modality) {
  return modality == Modality::kSpaceAndHaptics || modality == Modality::kSpaceAndFixture;
}
bool has_guide(Modality modality) {
  return modality == Modality::kSpaceAndFixture;
}

// In the words of simulation/ModalityName, for lupdate.
[[maybe_unused]] constexpr const char* kModalityNames[] = {PELLUCIDA_WORDS("2-D image"), PELLUCIDA_WORDS("3-D view"),
                                                           PELLUCIDA_WORDS("3-D + haptics"),
                                                           PELLUCIDA_WORDS("3-D + haptics + guide")};

// What each adds, for its tip.
const char* modality_tip(Modality modality) {
  switch (modality) {
    case Modality::kFlatImage:
      return PELLUCIDA_WORDS("The microscope's image alone");
    case Modality::kSpace:
      return PELLUCIDA_WORDS("The image, and the membranes in 3-D");
    case Modality::kSpaceAndHaptics:
      return PELLUCIDA_WORDS("Both views, and the cell's force on the hand");
    case Modality::kSpaceAndFixture:
      break;
  }
  return PELLUCIDA_WORDS("Both views, the force, and the guide along the planned line");
}

}  // namespace

DisplayControl::DisplayControl(Parts parts, QPushButton& button)
    : QObject(&button), parts_(std::move(parts)), button_(button) {
  auto* menu = new QMenu(&button);
  menu->setToolTipsVisible(true);
  add_modalities(*menu);
  menu->addSeparator();
  if (parts_.has_truth) {
    truth_ = menu->addAction(words("True force of the virtual cell"));
    truth_->setObjectName("truth");
    truth_->setToolTip(words("Beside the measured one, from the specimen's own finite elements; never recorded"));
    truth_->setCheckable(true);
    truth_->setShortcut(Qt::Key_U);
    connect(truth_, &QAction::toggled, this, [this] { parts_.changed(); });
  }
  sounds_ = menu->addAction(words("Sounds at contact, puncture and alarms"));
  sounds_->setObjectName("sounds");
  sounds_->setCheckable(true);
  sounds_->setShortcut(Qt::Key_B);
  connect(sounds_, &QAction::toggled, this, [this](bool on) {
    if (on && !sound_) sound_ = std::make_unique<EventSound>();
    if (!on) sound_.reset();
  });
  keep_as(*sounds_, "sounds");
  // Keys of a menu that isn't open act too.
  button.addActions(menu->actions());
  button.setMenu(menu);
  noted_ = words_for_recording();
}

DisplayControl::~DisplayControl() = default;

void DisplayControl::add_modalities(QMenu& menu) {
  auto* choice = new QActionGroup(this);
  for (const Modality modality : kModalities) {
    if (has_force(modality) && !parts_.console) continue;
    const int number = static_cast<int>(modality);
    QAction* action = choice->addAction(menu.addAction(words(name_of(modality))));
    action->setObjectName(QString("modality_") + option_of(modality));
    action->setToolTip(words(modality_tip(modality)));
    action->setCheckable(true);
    action->setShortcut(QKeySequence(QString("Ctrl+%1").arg(number + 1)));
    connect(action, &QAction::triggered, this, [this, modality] { choose(modality); });
    modalities_ << action;
  }
  modalities_.back()->setChecked(true);
}

void DisplayControl::choose(Modality modality) {
  parts_.space->setVisible(has_space(modality));
  if (parts_.console) {
    parts_.console->haptics(has_force(modality));
    parts_.hand->set_guided(has_guide(modality));
  }
  follow();
  parts_.changed();
}

std::optional<Modality> DisplayControl::modality() const {
  const bool space = !parts_.space->isHidden(), force = parts_.console && parts_.console->haptics(),
             guide = parts_.console && parts_.console->guided();
  for (const Modality modality : kModalities) {
    if (has_space(modality) == space && has_force(modality) == force && has_guide(modality) == guide) return modality;
  }
  return std::nullopt;
}

// English, as all of a session.
std::string DisplayControl::words_for_recording() const {
  std::string text = "display: ";
  if (const auto one = modality()) return text + name_of(*one);
  text += name_of(parts_.space->isHidden() ? Modality::kFlatImage : Modality::kSpace);
  if (parts_.console->haptics()) text += " + haptics";
  if (parts_.console->guided()) text += " + guide";
  return text;
}

bool DisplayControl::shows_truth() const {
  return truth_ && truth_->isChecked();
}

void DisplayControl::follow() {
  const std::string now = words_for_recording();
  if (now == noted_) return;
  noted_ = now;
  parts_.remark(now);
  const auto one = modality();
  for (int k = 0; k < modalities_.size(); ++k) modalities_[k]->setChecked(one && static_cast<int>(*one) == k);
}

void DisplayControl::hear(std::span<const Event> events, std::span<const Gauge> gauges, double now_s) {
  const auto cue = cues_.take(events, gauges, now_s);
  if (cue && sound_) sound_->play(*cue);
}

}  // namespace pellucida
