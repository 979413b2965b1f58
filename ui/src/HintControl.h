#pragma once
#include <Eigen/Core>
#include <QObject>
#include <functional>
#include <optional>
#include <string>

#include "pellucida/core/PersonHint.h"

class QAction;
class QMouseEvent;

namespace pellucida {

class FeedPanel;
class FeedView;

/// Hints by clicks on the image: a menu in the panel's head, with a key for each, says what the next click means ("this
/// is the cell", "here is the tip", "this is no cell"); the same key again, or the right button, says that there is
/// none. Another key takes the latest hint back.
class HintControl : public QObject {
 public:
  using Given = std::function<void(PersonHint::Kind, const Eigen::Vector2d& place_um)>;

  /// All must outlive the control. What it takes of the mouse no other part of the window gets: to be made after them.
  HintControl(FeedView& feed, FeedPanel& panel, Given given, std::function<void()> take_back);

  /// What the next click on the image means; nothing: what it always does.
  const std::optional<PersonHint::Kind>& waiting() const noexcept { return waiting_; }
  void wait_for(std::optional<PersonHint::Kind> kind);

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  void add_menu(std::function<void()> take_back);
  bool take_press(const QMouseEvent& event);

  FeedView& feed_;
  FeedPanel& panel_;
  Given given_;
  std::optional<PersonHint::Kind> waiting_;
  std::string prompt_;
  bool swallows_release_ = false;
};

/// What a mark on the image says of a hint.
std::string hint_words(PersonHint::Kind kind);

}  // namespace pellucida
