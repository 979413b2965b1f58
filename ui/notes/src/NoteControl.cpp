#include "pellucida/notes/NoteControl.h"

#include <QAction>
#include <QApplication>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "Measured.h"
#include "NoteBook.h"
#include "Words.h"
#include "pellucida/core/Error.h"
#include "pellucida/visualization/Readout.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "widgets/FeedPanel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr int kLongestNote = 500;

}  // namespace

NoteControl::NoteControl(FeedView& feed, FeedPanel& panel, Actions actions)
    : QObject(&panel), feed_(feed), panel_(panel), actions_(std::move(actions)), book_(std::make_unique<NoteBook>()) {
  build_button();
  build_strip();
  qApp->installEventFilter(this);
}

NoteControl::~NoteControl() = default;

void NoteControl::build_button() {
  button_ = new QPushButton(words("Note \u25BE"));
  button_->setObjectName("note");
  button_->setFixedHeight(30);
  button_->setFocusPolicy(Qt::TabFocus);
  button_->setToolTip(words("Write a note into the session: at this time, on a node or at a place in the image"));
  auto* menu = new QMenu(button_);
  const auto add = [&](const char* name, const QString& text, const QKeySequence& key, std::function<void()> act) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, std::move(act));
    // Keys of a menu that isn't open act too.
    button_->addAction(action);
  };
  add("noteHere", words("At this time, on the node picked"), QKeySequence("A"), [this] { begin(std::nullopt); });
  add("notePlace", words("At a place in the image"), QKeySequence("Shift+A"), [this] { wait_for_click(!waits_); });
  menu->addSeparator();
  add("noteUndo", words("Undo"), QKeySequence::Undo, [this] { step_back(false); });
  add("noteRedo", words("Redo"), QKeySequence("Ctrl+Shift+Z"), [this] { step_back(true); });
  button_->setMenu(menu);
}

void NoteControl::build_strip() {
  strip_ = new QFrame;
  strip_->setObjectName("noteStrip");
  strip_->setAttribute(Qt::WA_StyledBackground);
  strip_->setFixedHeight(44);
  auto* row = new QHBoxLayout(strip_);
  row->setContentsMargins(16, 6, 16, 6);
  row->setSpacing(10);
  where_ = new QLabel;
  where_->setObjectName("noteWhere");
  where_->setTextFormat(Qt::PlainText);
  row->addWidget(where_);
  text_ = new QLineEdit;
  text_->setObjectName("noteText");
  text_->setMaxLength(kLongestNote);
  text_->setPlaceholderText(words("Your note; Enter keeps it"));
  text_->setAccessibleName(words("Note"));
  where_->setBuddy(text_);
  connect(text_, &QLineEdit::returnPressed, this, [this] { write(); });
  row->addWidget(text_, 1);
  next_ = new QPushButton;
  next_->setObjectName("noteNext");
  next_->setFixedHeight(30);
  next_->setFocusPolicy(Qt::TabFocus);
  next_->setToolTip(words("This frame has several notes: the next one"));
  connect(next_, &QPushButton::clicked, this, [this] { leaf(1); });
  row->addWidget(next_);
  delete_ = new QPushButton(words("Delete"));
  delete_->setObjectName("noteDelete");
  delete_->setFixedHeight(30);
  delete_->setFocusPolicy(Qt::TabFocus);
  connect(delete_, &QPushButton::clicked, this, [this] { remove(); });
  row->addWidget(delete_);
  strip_->hide();
}

void NoteControl::set_session(const std::filesystem::path& folder, double pixel_size_um) {
  pixel_size_um_ = pixel_size_um;
  wait_for_click(false);
  draft_.reset();
  shown_.reset();
  strip_->hide();
  attempt([&] { book_->open(folder); });
}

const std::vector<Annotation>& NoteControl::notes() const noexcept {
  return book_->notes();
}

std::vector<HintMark> NoteControl::marks_at(double time_s) const {
  std::vector<HintMark> marks;
  for (const Annotation& note : book_->notes()) {
    if (note.place_um && std::abs(note.time_s - time_s) < 5e-4) {
      HintMark mark{{note.place_um->x_um, note.place_um->y_um}, note.text, {}};
      for (const Annotation::Place& place : note.further_um) mark.further_um.emplace_back(place.x_um, place.y_um);
      if (const auto result = measured(note, pixel_size_um_)) {
        mark.text = (note.text.empty() ? "" : note.text + ": ") + words_of(*result);
      }
      marks.push_back(std::move(mark));
    }
  }
  return marks;
}

std::string NoteControl::listed(const Annotation& note) const {
  if (const auto result = measured(note, pixel_size_um_)) {
    return (note.text.empty() ? "" : note.text + ": ") + words_of(*result);
  }
  if (!note.node && !note.place_um) return note.text;
  return note.text + " (" + where_of(note) + ')';
}

void NoteControl::show_at(double time_s) {
  // What is being written stays until another time is shown.
  if (draft_ && std::abs(draft_->time_s - time_s) < 5e-4) return;
  draft_.reset();
  shown_s_ = time_s;
  const auto here = book_->at(time_s);
  // The last one, unless another was chosen.
  if (!shown_ || std::find(here.begin(), here.end(), *shown_) == here.end()) {
    shown_ = here.empty() ? std::nullopt : std::optional(here.back());
  }
  show_note();
}

void NoteControl::show_note() {
  if (!shown_) return strip_->hide();
  const auto here = book_->at(shown_s_);
  const Annotation& note = book_->notes()[*shown_];
  const auto result = measured(note, pixel_size_um_);
  where_->setText(result ? QString::fromStdString(words_of(*result) + say(" at ") + readout::time(note.time_s))
                         : words("Note at ") + QString::fromStdString(where_of(note)));
  const auto place = std::find(here.begin(), here.end(), *shown_) - here.begin();
  next_->setText(QString("%1 / %2 \u203A").arg(place + 1).arg(here.size()));
  next_->setAccessibleName(words("Next note of this frame"));
  next_->setVisible(here.size() > 1);
  text_->setText(QString::fromStdString(note.text));
  delete_->setEnabled(true);
  strip_->show();
}

void NoteControl::leaf(int by) {
  const auto here = book_->at(shown_s_);
  if (here.empty() || !shown_) return;
  const auto place = std::find(here.begin(), here.end(), *shown_) - here.begin();
  shown_ = here[static_cast<std::size_t>(place + by) % here.size()];
  show_note();
}

bool NoteControl::ready() {
  if (!actions_.moment()) return false;
  if (book_->is_open()) return true;
  actions_.notify(words("This session's annotations can't be read: mend or remove annotations.csv first"), true);
  return false;
}

void NoteControl::keep(Annotation note) {
  const auto moment = actions_.moment();
  if (!moment) return;
  note.time_s = moment->time_s;
  draft_.reset();
  shown_.reset();
  shown_s_ = moment->time_s;
  attempt([&] { book_->add(note); });
}

void NoteControl::begin(std::optional<Eigen::Vector2d> place_um) {
  const auto moment = actions_.moment();
  if (!moment) return;
  if (!ready()) return;
  draft_ = Annotation{.time_s = moment->time_s, .place_um = {}, .further_um = {}, .node = moment->node, .text = {}};
  if (place_um) {
    draft_->place_um = Annotation::Place{place_um->x(), place_um->y()};
    draft_->node.reset();
  }
  shown_.reset();
  shown_s_ = moment->time_s;
  where_->setText(words("New note at ") + QString::fromStdString(where_of(*draft_)));
  text_->clear();
  delete_->setEnabled(false);
  strip_->show();
  text_->setFocus(Qt::OtherFocusReason);
}

void NoteControl::write() {
  const std::string text = text_->text().trimmed().toStdString();
  const bool measures = shown_ && !book_->notes()[*shown_].further_um.empty();
  if (text.empty() && !measures) return;
  attempt([&] {
    if (draft_) {
      draft_->text = text;
      book_->add(*draft_);
      draft_.reset();
      actions_.notify(words("Note kept"), false);
    } else if (shown_) {
      book_->edit(*shown_, text);
      actions_.notify(words("Note changed"), false);
    }
  });
  text_->clearFocus();
}

void NoteControl::remove() {
  if (!shown_) return;
  attempt([&] {
    book_->remove(*shown_);
    shown_.reset();
    actions_.notify(words("Note deleted; Ctrl+Z brings it back"), false);
  });
}

void NoteControl::step_back(bool forwards) {
  if (!(forwards ? book_->can_redo() : book_->can_undo())) {
    actions_.notify(forwards ? words("There is nothing to redo") : words("There is nothing to undo"), false);
    return;
  }
  draft_.reset();
  shown_.reset();
  attempt([&] { forwards ? book_->redo() : book_->undo(); });
}

void NoteControl::attempt(const std::function<void()>& change) {
  try {
    change();
  } catch (const Error& error) {
    actions_.notify(words_of(error), true);
  }
  show_at(shown_s_);
  actions_.changed();
}

void NoteControl::wait_for_click(bool waits) {
  if (waits && !actions_.moment()) return;
  waits_ = waits;
  prompt_ = waits ? say("Click the place of the note (Shift+A: not now)") : std::string();
  feed_.set_prompt(prompt_);
  if (waits) {
    panel_.view().setCursor(Qt::CrossCursor);
  } else {
    panel_.view().unsetCursor();
  }
  panel_.view().render();
}

bool NoteControl::eventFilter(QObject* target, QEvent* event) {
  if (target == text_ && event->type() == QEvent::KeyPress &&
      static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    draft_.reset();
    text_->clearFocus();
    show_at(shown_s_);
    return true;
  }
  if (target != &panel_.view()) return false;
  if (event->type() == QEvent::MouseButtonRelease) return std::exchange(swallows_release_, false);
  // Another click may be waited for since.
  if (feed_.prompt() != prompt_) waits_ = false;
  if (!waits_ || event->type() != QEvent::MouseButtonPress) return false;
  const auto& mouse = static_cast<const QMouseEvent&>(*event);
  swallows_release_ = true;
  const Eigen::Vector2d place_um = feed_.place_um(mouse.localPos().x(), mouse.localPos().y(), panel_.view().height());
  wait_for_click(false);
  if (mouse.button() == Qt::LeftButton) begin(place_um);
  return true;
}

}  // namespace pellucida
