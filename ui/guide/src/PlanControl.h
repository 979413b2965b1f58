#pragma once
#include <Eigen/Core>
#include <QCursor>
#include <QObject>
#include <QPointF>
#include <QUndoStack>
#include <functional>
#include <optional>

#include "presenters/PlanEdit.h"

class QAction;
class QMouseEvent;

namespace pellucida {

class FeedPanel;
class FeedView;
class OperatorConsole;

/// The plan over the image, and changes of it by the mouse: Ctrl and a click set the target; while the cell is
/// untouched, target, entry and depth stop have handles to drag. Undo and redo; the whole plan can be hidden.
class PlanControl : public QObject {
 public:
  /// What is said to the person: the text, and whether it is a problem.
  using Notify = std::function<void(const QString&, bool)>;

  /// All must outlive the control. What it takes of the mouse the hand does not get: to be made after its control.
  PlanControl(OperatorConsole& console, FeedView& feed, FeedPanel& panel, Notify notify);

  /// From the window's tick. True when the feed has to be drawn again.
  bool tick();

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  friend class PlanChange;
  void add_menu();
  void offer_undo_and_redo();
  bool take_press(const QMouseEvent& event);
  bool take_move(const QMouseEvent& event);
  bool take_release(const QMouseEvent& event);
  void hover(PlanHandle handle);
  void change(const PlanChoice& to, const QString& what);
  bool apply(const PlanChoice& from, const PlanChoice& to);
  Eigen::Vector2d place_um(const QPointF& place_px) const;
  PlanHandle handle_under(const QPointF& place_px) const;
  PlanChoice choice() const;
  PlanMarks marks() const;

  OperatorConsole& console_;
  FeedView& feed_;
  FeedPanel& panel_;
  Notify notify_;
  QUndoStack changes_;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  bool is_applied_ = false;  // the latest change
  bool is_shown_ = true;
  bool is_click_ = false;                  // Ctrl and the button, until its release
  bool is_inside_ = false;                 // the mouse is on the image
  QCursor cursor_;                         // the image's own
  PlanHandle handle_ = PlanHandle::kNone;  // under the mouse, or dragged
  std::optional<PlanChoice> dragged_;      // to there, while it is
  std::optional<PlanMarks> drawn_;
  std::optional<Eigen::Vector2d> cell_um_;  // of the plan whose changes can be undone
};

}  // namespace pellucida
