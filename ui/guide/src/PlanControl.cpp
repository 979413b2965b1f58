#include "PlanControl.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QToolButton>
#include <QUndoCommand>

#include "WindowMemory.h"
#include "Words.h"
#include "pellucida/operation/OperatorConsole.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "widgets/FeedPanel.h"
#include "widgets/KeySheet.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr double kReach_px = 11.0;
// A plan of another cell: its centre is elsewhere by more than that.
constexpr double kOtherCell_um = 1.0;

}  // namespace

// One change of the plan, there and back.
class PlanChange : public QUndoCommand {
 public:
  PlanChange(PlanControl& control, const PlanChoice& from, const PlanChoice& to, const QString& what)
      : QUndoCommand(what), control_(control), from_(from), to_(to) {}
  void redo() override { take(from_, to_); }
  void undo() override { take(to_, from_); }

 private:
  void take(const PlanChoice& from, const PlanChoice& to) {
    if (!control_.apply(from, to)) setObsolete(true);
  }

  PlanControl& control_;
  PlanChoice from_, to_;
};

PlanControl::PlanControl(OperatorConsole& console, FeedView& feed, FeedPanel& panel, Notify notify)
    : QObject(&panel), console_(console), feed_(feed), panel_(panel), notify_(std::move(notify)) {
  add_menu();
  explain_gesture(panel_, words("Ctrl+click"), words("Set the target"));
  explain_gesture(panel_, words("Drag a ring"), words("Move target, entry or depth stop of the plan"));
  qApp->installEventFilter(this);
}

void PlanControl::add_menu() {
  QToolButton* button =
      panel_.add_button(words("Plan \u25BE"), words("The planned way: drag its rings while the cell is untouched"));
  button->setObjectName("plan");
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  QAction* shown = menu->addAction(words("Show the plan"));
  shown->setObjectName("planShown");
  shown->setCheckable(true);
  shown->setChecked(true);
  shown->setShortcut(Qt::Key_P);
  connect(shown, &QAction::toggled, this, [this](bool on) { is_shown_ = on; });
  keep_as(*shown, "plan");
  menu->addSeparator();
  QAction* undo = menu->addAction(words("Undo the plan's change"));
  undo->setObjectName("planUndo");
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = menu->addAction(words("Redo the plan's change"));
  redo->setObjectName("planRedo");
  redo->setShortcut(QKeySequence("Ctrl+Shift+Z"));
  undo_ = undo;
  redo_ = redo;
  connect(undo, &QAction::triggered, &changes_, &QUndoStack::undo);
  connect(redo, &QAction::triggered, &changes_, &QUndoStack::redo);
  // At once, not with the next drawing: whoever types fast is not ignored.
  connect(&changes_, &QUndoStack::indexChanged, this, [this] { offer_undo_and_redo(); });
  // Keys of a menu that isn't open act too.
  panel_.addActions({shown, undo, redo});
  button->setMenu(menu);
}

PlanChoice PlanControl::choice() const {
  return choice_of(*console_.plan(), console_.depth_stop_um());
}

PlanMarks PlanControl::marks() const {
  const InjectionPlan& plan = *console_.plan();
  const PlanChoice now = dragged_.value_or(choice());
  const auto changed = plan_with(plan, now);
  PlanMarks marks = plan_marks(changed ? *changed : plan, now.depth_stop_um, console_.guided());
  marks.has_handles = is_inside_ && console_.may_replan();
  marks.handle = handle_;
  return marks;
}

void PlanControl::offer_undo_and_redo() {
  undo_->setEnabled(changes_.canUndo() && console_.may_replan());
  redo_->setEnabled(changes_.canRedo() && console_.may_replan());
}

bool PlanControl::tick() {
  // What was changed of another cell's plan is past.
  if (console_.plan()) {
    const Eigen::Vector2d cell_um = console_.plan()->cell.center_um.eigen().head<2>();
    if (cell_um_ && (*cell_um_ - cell_um).norm() > kOtherCell_um) changes_.clear();
    cell_um_ = cell_um;
  } else {
    changes_.clear();
    cell_um_.reset();
  }
  if (handle_ != PlanHandle::kNone && (!console_.may_replan() || !is_shown_)) {
    dragged_.reset();
    feed_.set_prompt({});
    hover(PlanHandle::kNone);
  }
  offer_undo_and_redo();
  std::optional<PlanMarks> now;
  if (console_.plan() && is_shown_) now = marks();
  if (now == drawn_) return false;
  drawn_ = now;
  feed_.set_plan(drawn_);
  return true;
}

Eigen::Vector2d PlanControl::place_um(const QPointF& place_px) const {
  return feed_.place_um(place_px.x(), place_px.y(), panel_.view().height());
}

PlanHandle PlanControl::handle_under(const QPointF& place_px) const {
  if (!is_shown_ || !console_.may_replan()) return PlanHandle::kNone;
  const double reach_um = (place_um(place_px + QPointF(kReach_px, 0.0)) - place_um(place_px)).norm();
  return handle_at(marks(), place_um(place_px), reach_um);
}

void PlanControl::hover(PlanHandle handle) {
  if (handle == handle_) return;
  if (handle_ == PlanHandle::kNone) cursor_ = panel_.view().cursor();
  handle_ = handle;
  panel_.view().setCursor(handle == PlanHandle::kNone ? cursor_ : QCursor(Qt::SizeAllCursor));
}

bool PlanControl::eventFilter(QObject* target, QEvent* event) {
  if (target != &panel_.view() || !console_.plan()) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return take_press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return take_move(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      return take_release(static_cast<const QMouseEvent&>(*event));
    case QEvent::Leave:
      is_inside_ = false;
      if (!dragged_) hover(PlanHandle::kNone);
      return false;
    default:
      return false;
  }
}

bool PlanControl::take_press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  if ((event.modifiers() & Qt::ControlModifier) != 0) {
    is_click_ = true;
    PlanChoice to = choice();
    to.target_um = place_um(event.localPos());
    change(to, words("Target set"));
    return true;
  }
  hover(handle_under(event.localPos()));
  if (handle_ == PlanHandle::kNone) return false;
  dragged_ = choice();
  panel_.view().setCursor(Qt::ClosedHandCursor);
  return true;
}

bool PlanControl::take_move(const QMouseEvent& event) {
  is_inside_ = true;
  if (dragged_) {
    dragged_ = drag_handle(*console_.plan(), choice(), handle_, place_um(event.localPos()));
    feed_.set_prompt(handle_words(*console_.plan(), *dragged_, handle_));
    return true;
  }
  // Held buttons turn and move the view, or lead the needle.
  if (event.buttons() == Qt::NoButton) hover(handle_under(event.localPos()));
  return false;
}

bool PlanControl::take_release(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  if (std::exchange(is_click_, false)) return true;
  if (!dragged_) return false;
  const PlanChoice to = *dragged_;
  dragged_.reset();
  feed_.set_prompt({});
  const bool is_stop = handle_ == PlanHandle::kDepthStop;
  hover(PlanHandle::kNone);
  change(to, is_stop ? words("Depth stop set") : words("Target set"));
  return true;
}

void PlanControl::change(const PlanChoice& to, const QString& what) {
  const PlanChoice from = choice();
  if (from == to) return;
  if (!console_.may_replan()) {
    apply(from, to);
    return;
  }
  is_applied_ = false;
  changes_.push(new PlanChange(*this, from, to, what));
  if (is_applied_) notify_(what, false);
}

// True where it is in force. What is the same in both stays as it is: a depth stop that follows the target goes on to.
bool PlanControl::apply(const PlanChoice& from, const PlanChoice& to) {
  if (!console_.plan()) return false;
  if (to.depth_stop_um != from.depth_stop_um) console_.depth_stop_um(to.depth_stop_um);
  is_applied_ = true;
  if (to.target_um == from.target_um) return true;
  const auto objection = console_.set_target(to.target_um.x(), to.target_um.y());
  if (objection) notify_(words("Target: ") + QString::fromStdString(say_message(*objection)), true);
  is_applied_ = !objection;
  return is_applied_;
}

}  // namespace pellucida
