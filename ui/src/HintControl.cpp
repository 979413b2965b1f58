#include "HintControl.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QToolButton>
#include <utility>

#include "Words.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "widgets/FeedPanel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

using Kind = PersonHint::Kind;

struct HintEntry {
  Kind kind;
  const char* name;
  const char* text;
  const char* key;
  const char* prompt;
};
constexpr HintEntry kEntries[] = {
    {Kind::kCell, "hintCell", PELLUCIDA_WORDS("This is the cell"), "O", PELLUCIDA_WORDS("Click inside the cell")},
    {Kind::kNeedleTip, "hintTip", PELLUCIDA_WORDS("Here is the tip"), "T", PELLUCIDA_WORDS("Click the needle's tip")},
    {Kind::kCellOutline, "hintOutline", PELLUCIDA_WORDS("This is the cell's outline"), "K",
     PELLUCIDA_WORDS("Drag once round the cell")},
    {Kind::kHolder, "hintHolder", PELLUCIDA_WORDS("Here is the holding pipette"), "Shift+H",
     PELLUCIDA_WORDS("Click the holding pipette, near the cell")},
    {Kind::kNoCell, "hintNoCell", PELLUCIDA_WORDS("This is no cell"), "Shift+O",
     PELLUCIDA_WORDS("Click what is no cell")},
};

// A mouse that has gone less, px of the widget, has not moved.
constexpr double kStep_px = 3.0;

}  // namespace

HintControl::HintControl(FeedView& feed, FeedPanel& panel, Actions actions)
    : QObject(&panel), feed_(feed), panel_(panel), actions_(std::move(actions)) {
  add_menu();
  // The newest filter sees an event first: a click that is waited for moves no needle.
  qApp->installEventFilter(this);
}

void HintControl::add_menu() {
  QToolButton* button = panel_.add_button(
      words("Hint \u25BE"), words("Point at what the tracking took for something else: it goes on from there"));
  button->setObjectName("hints");
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  const auto add = [&](const char* name, const QString& text, const QKeySequence& key, std::function<void()> act) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, std::move(act));
    // Keys of a menu that isn't open act too.
    panel_.addAction(action);
  };
  for (const HintEntry& entry : kEntries) {
    add(entry.name, words(entry.text), QKeySequence(entry.key),
        [this, kind = entry.kind] { wait_for(waiting_ == kind ? std::nullopt : std::optional(kind)); });
  }
  menu->addSeparator();
  add("hintTakeBack", words("Take back the last hint"), QKeySequence(Qt::Key_Backspace), [this] {
    wait_for(std::nullopt);
    actions_.take_back();
  });
  button->setMenu(menu);
}

void HintControl::wait_for(std::optional<Kind> kind) {
  waiting_ = kind;
  const bool was_drawing = !std::exchange(drawn_um_, {}).empty();
  std::string& prompt = prompt_;
  prompt.clear();
  for (const HintEntry& entry : kEntries) {
    if (kind == entry.kind) prompt = say(entry.prompt) + " (" + entry.key + say(": not now)");
  }
  feed_.set_prompt(prompt);
  if (kind) {
    panel_.view().setCursor(Qt::CrossCursor);
  } else {
    panel_.view().unsetCursor();
  }
  if (was_drawing) actions_.drawn();
  panel_.view().render();
}

std::vector<HintMark> HintControl::marks() const {
  if (drawn_um_.size() < 2) return {};
  HintMark mark{{drawn_um_.front()[0], drawn_um_.front()[1]}, {}, {}};
  for (std::size_t k = 1; k < drawn_um_.size(); ++k) mark.further_um.emplace_back(drawn_um_[k][0], drawn_um_[k][1]);
  return {mark};
}

bool HintControl::eventFilter(QObject* target, QEvent* event) {
  if (target != &panel_.view()) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return take_press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return take_move(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      return take_release();
    default:
      return false;
  }
}

Eigen::Vector2d HintControl::place_um(const QMouseEvent& event) const {
  return feed_.place_um(event.localPos().x(), event.localPos().y(), panel_.view().height());
}

bool HintControl::take_press(const QMouseEvent& event) {
  // Another click may be waited for since.
  if (feed_.prompt() != prompt_) waiting_.reset();
  if (!waiting_) return false;
  swallows_release_ = true;
  const Kind kind = *waiting_;
  const Eigen::Vector2d place = place_um(event);
  const bool is_left = event.button() == Qt::LeftButton;
  if (is_left && kind == Kind::kCellOutline) {
    drawn_um_ = {{place.x(), place.y()}};
    return true;
  }
  wait_for(std::nullopt);
  if (is_left) actions_.given({.kind = kind, .x_um = place.x(), .y_um = place.y()});
  return true;
}

bool HintControl::take_move(const QMouseEvent& event) {
  if (drawn_um_.empty()) return false;
  const Eigen::Vector2d place = place_um(event), last(drawn_um_.back()[0], drawn_um_.back()[1]);
  const Eigen::Vector2d step_um =
      feed_.place_um(kStep_px, 0.0, panel_.view().height()) - feed_.place_um(0.0, 0.0, panel_.view().height());
  if ((place - last).norm() < step_um.norm()) return true;
  drawn_um_.push_back({place.x(), place.y()});
  actions_.drawn();
  panel_.view().render();
  return true;
}

bool HintControl::take_release() {
  if (!drawn_um_.empty()) {
    const std::optional<PersonHint> hint = outline_hint(drawn_um_);
    wait_for(std::nullopt);
    if (hint) {
      actions_.given(*hint);
    } else {
      actions_.notify(words("That was no outline: press the mouse on the cell's edge, and drag once round it"), true);
    }
  }
  return std::exchange(swallows_release_, false);
}

}  // namespace pellucida
