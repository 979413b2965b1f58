#pragma once
#include <Eigen/Core>
#include <QObject>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pellucida/visualization/PlanMarks.h"

class QAction;
class QPushButton;

namespace pellucida {

class FeedPanel;
class FeedView;
class NoteControl;

/// Distances and angles on the image of a recorded session: a button with a menu and keys (D: two clicks, a distance;
/// Shift+D: three, an angle at the second; Esc, the right button or the same key: no more). What was measured is a note
/// of the frame shown: listed, named, deleted and undone as notes are.
class MeasureControl : public QObject {
 public:
  struct Actions {
    std::function<void()> changed;  ///< the marks on the image
    std::function<void()> save;     ///< what was measured, as a table
  };

  /// All must outlive the control. What it takes of the mouse no other part of the window gets: to be made after them.
  MeasureControl(FeedView& feed, FeedPanel& panel, NoteControl& notes, Actions actions);

  /// Belongs to the widget that it is put into.
  QPushButton& button() noexcept { return *button_; }
  /// Places that are waited for: 2 for a distance, 3 for an angle; 0: none.
  std::size_t waiting() const noexcept { return wanted_; }
  /// What was clicked so far, up to the mouse.
  std::vector<HintMark> marks() const;
  /// The table of what was measured. Throws OutputError.
  void write(const std::filesystem::path& file) const;

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  void wait_for(std::size_t places);
  bool take_press(const Eigen::Vector2d& place_um, bool is_left);
  void show_prompt();

  FeedView& feed_;
  FeedPanel& panel_;
  NoteControl& notes_;
  Actions actions_;
  QPushButton* button_ = nullptr;
  std::size_t wanted_ = 0;
  std::vector<Eigen::Vector2d> places_um_;
  Eigen::Vector2d mouse_um_ = Eigen::Vector2d::Zero();
  std::string prompt_;
  bool swallows_release_ = false;
};

}  // namespace pellucida
