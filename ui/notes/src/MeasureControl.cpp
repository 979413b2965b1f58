#include "pellucida/notes/MeasureControl.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <utility>

#include "Measured.h"
#include "Words.h"
#include "pellucida/notes/NoteControl.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "widgets/FeedPanel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr std::size_t kDistancePlaces = 2, kAnglePlaces = 3;
constexpr const char* kDistancePrompts[] = {PELLUCIDA_WORDS("Click one end of the distance"),
                                            PELLUCIDA_WORDS("Click the other end")};
constexpr const char* kAnglePrompts[] = {PELLUCIDA_WORDS("Click the end of one leg"),
                                         PELLUCIDA_WORDS("Click the angle's vertex"),
                                         PELLUCIDA_WORDS("Click the end of the other leg")};

Annotation note_of(const std::vector<Eigen::Vector2d>& places_um) {
  Annotation note;
  note.place_um = Annotation::Place{places_um.front().x(), places_um.front().y()};
  for (std::size_t k = 1; k < places_um.size(); ++k) note.further_um.push_back({places_um[k].x(), places_um[k].y()});
  return note;
}

}  // namespace

MeasureControl::MeasureControl(FeedView& feed, FeedPanel& panel, NoteControl& notes, Actions actions)
    : QObject(&panel), feed_(feed), panel_(panel), notes_(notes), actions_(std::move(actions)) {
  button_ = new QPushButton(words("Measure \u25BE"));
  button_->setObjectName("measure");
  button_->setFixedHeight(30);
  button_->setFocusPolicy(Qt::TabFocus);
  button_->setToolTip(words("Distances and angles on the image, kept with the session's notes"));
  auto* menu = new QMenu(button_);
  const auto add = [&](const char* name, const QString& text, const QKeySequence& key, std::function<void()> act) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, std::move(act));
    // Keys of a menu that isn't open act too.
    if (!key.isEmpty()) button_->addAction(action);
  };
  add("measureDistance", words("A distance: two clicks"), QKeySequence("D"),
      [this] { wait_for(wanted_ == kDistancePlaces ? 0 : kDistancePlaces); });
  add("measureAngle", words("An angle: three clicks, the second at its vertex"), QKeySequence("Shift+D"),
      [this] { wait_for(wanted_ == kAnglePlaces ? 0 : kAnglePlaces); });
  menu->addSeparator();
  add("measureSave", words("What was measured as CSV\u2026"), {}, [this] { actions_.save(); });
  button_->setMenu(menu);
  panel_.view().setMouseTracking(true);
  qApp->installEventFilter(this);
}

void MeasureControl::wait_for(std::size_t places) {
  if (places > 0 && !notes_.ready()) return;
  wanted_ = places;
  places_um_.clear();
  if (places > 0) {
    panel_.view().setCursor(Qt::CrossCursor);
  } else {
    panel_.view().unsetCursor();
  }
  show_prompt();
  actions_.changed();
}

void MeasureControl::show_prompt() {
  prompt_.clear();
  if (wanted_ > 0) {
    const char* text = (wanted_ == kAnglePlaces ? kAnglePrompts : kDistancePrompts)[places_um_.size()];
    prompt_ = say(text) + say(" (Esc: no more)");
  }
  feed_.set_prompt(prompt_);
}

std::vector<HintMark> MeasureControl::marks() const {
  if (wanted_ == 0 || places_um_.empty()) return {};
  std::vector<Eigen::Vector2d> places_um = places_um_;
  places_um.push_back(mouse_um_);
  const auto result = measured(note_of(places_um), notes_.pixel_size_um());
  HintMark mark{places_um.front(), result ? words_of(*result) : std::string(), {}};
  mark.further_um.assign(places_um.begin() + 1, places_um.end());
  return {mark};
}

void MeasureControl::write(const std::filesystem::path& file) const {
  write_measured(notes_.notes(), notes_.pixel_size_um(), file);
}

bool MeasureControl::take_press(const Eigen::Vector2d& place_um, bool is_left) {
  swallows_release_ = true;
  if (!is_left) {
    wait_for(0);
    return true;
  }
  places_um_.push_back(place_um);
  mouse_um_ = place_um;
  if (places_um_.size() == wanted_) {
    const Annotation note = note_of(places_um_);
    // The next one can be measured at once.
    places_um_.clear();
    show_prompt();
    notes_.keep(note);
    return true;
  }
  show_prompt();
  actions_.changed();
  return true;
}

bool MeasureControl::eventFilter(QObject* target, QEvent* event) {
  if (wanted_ == 0 && !swallows_release_) return false;
  // Another click is waited for since.
  if (wanted_ > 0 && feed_.prompt() != prompt_) {
    wanted_ = 0;
    places_um_.clear();
    actions_.changed();
    return false;
  }
  if (wanted_ > 0 && event->type() == QEvent::ShortcutOverride &&
      static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    wait_for(0);
    event->accept();
    return true;
  }
  if (target != &panel_.view()) return false;
  if (event->type() == QEvent::MouseButtonRelease) return std::exchange(swallows_release_, false);
  const bool pressed = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
  if (wanted_ == 0 || (!pressed && event->type() != QEvent::MouseMove)) return false;
  const auto& mouse = static_cast<const QMouseEvent&>(*event);
  const Eigen::Vector2d place_um = feed_.place_um(mouse.localPos().x(), mouse.localPos().y(), panel_.view().height());
  if (pressed) return take_press(place_um, mouse.button() == Qt::LeftButton);
  if (!places_um_.empty() && mouse.buttons() == Qt::NoButton) {
    mouse_um_ = place_um;
    actions_.changed();
  }
  return false;
}

}  // namespace pellucida
