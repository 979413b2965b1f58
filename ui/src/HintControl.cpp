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
    {Kind::kNoCell, "hintNoCell", PELLUCIDA_WORDS("This is no cell"), "Shift+O",
     PELLUCIDA_WORDS("Click what is no cell")},
};

}  // namespace

std::string hint_words(Kind kind) {
  switch (kind) {
    case Kind::kCell:
      return words("cell");
    case Kind::kNeedleTip:
      return words("tip");
    case Kind::kNoCell:
      return words("no cell");
    case Kind::kTakeBack:
      break;
  }
  return words("taken back");
}

HintControl::HintControl(FeedView& feed, FeedPanel& panel, Given given, std::function<void()> take_back)
    : QObject(&panel), feed_(feed), panel_(panel), given_(std::move(given)) {
  add_menu(std::move(take_back));
  // The newest filter sees an event first: a click that is waited for moves no needle.
  qApp->installEventFilter(this);
}

void HintControl::add_menu(std::function<void()> take_back) {
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
  add("hintTakeBack", words("Take back the last hint"), QKeySequence(Qt::Key_Backspace), [this, take_back] {
    wait_for(std::nullopt);
    take_back();
  });
  button->setMenu(menu);
}

void HintControl::wait_for(std::optional<Kind> kind) {
  waiting_ = kind;
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
  panel_.view().render();
}

bool HintControl::eventFilter(QObject* target, QEvent* event) {
  if (target != &panel_.view()) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return take_press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      return std::exchange(swallows_release_, false);
    default:
      return false;
  }
}

bool HintControl::take_press(const QMouseEvent& event) {
  // Another click may be waited for since.
  if (feed_.prompt() != prompt_) waiting_.reset();
  if (!waiting_) return false;
  swallows_release_ = true;
  const Kind kind = *waiting_;
  const Eigen::Vector2d place_um = feed_.place_um(event.localPos().x(), event.localPos().y(), panel_.view().height());
  wait_for(std::nullopt);
  if (event.button() == Qt::LeftButton) given_(kind, place_um);
  return true;
}

}  // namespace pellucida
