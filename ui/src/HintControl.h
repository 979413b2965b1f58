#pragma once
#include <Eigen/Core>
#include <QObject>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core/PersonHint.h"
#include "pellucida/visualization/PlanMarks.h"

class QAction;
class QMouseEvent;

namespace pellucida {

class FeedPanel;
class FeedView;

/// Hints by the mouse on the image: a menu in the panel's head, with a key for each, says what the next click means
/// ("this is the cell", "here is the tip", "here is the holding pipette", "this is no cell"), or that the next drag
/// goes round the cell; the same key again, or the right button, says that there is none. Another key takes the latest
/// hint back.
class HintControl : public QObject {
 public:
  struct Actions {
    std::function<void(const PersonHint&)> given;
    std::function<void()> take_back;
    std::function<void()> drawn;                                    ///< `marks` have changed, while an outline is drawn
    std::function<void(const QString& text, bool problem)> notify;  ///< of an outline that is none
  };

  /// All must outlive the control. What it takes of the mouse no other part of the window gets: to be made after them.
  HintControl(FeedView& feed, FeedPanel& panel, Actions actions);

  /// What the next click or drag on the image means; nothing: what it always does.
  const std::optional<PersonHint::Kind>& waiting() const noexcept { return waiting_; }
  void wait_for(std::optional<PersonHint::Kind> kind);

  /// The outline as far as it is drawn; empty else.
  std::vector<HintMark> marks() const;

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  void add_menu();
  Eigen::Vector2d place_um(const QMouseEvent& event) const;
  bool take_press(const QMouseEvent& event);
  bool take_move(const QMouseEvent& event);
  bool take_release();

  FeedView& feed_;
  FeedPanel& panel_;
  Actions actions_;
  std::optional<PersonHint::Kind> waiting_;
  std::vector<PersonHint::Place_um> drawn_um_;  // of the outline, while the button is down
  std::string prompt_;
  bool swallows_release_ = false;
};

}  // namespace pellucida
