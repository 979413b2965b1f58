#pragma once
#include <Eigen/Core>
#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/session/Annotations.h"
#include "pellucida/visualization/PlanMarks.h"

class QFrame;
class QLabel;
class QLineEdit;
class QMouseEvent;
class QPushButton;

namespace pellucida {

class FeedPanel;
class FeedView;
class NoteBook;

/// What is shown when a note is made.
struct NoteMoment {
  double time_s = 0.0;
  std::optional<long> node;  ///< the one that is picked
};

/// Annotations of a recorded session in a window: a button with a menu and keys (A: a note at this time, on the node
/// that is picked; Shift+A: at the place of the next click on the image; Ctrl+Z, Ctrl+Shift+Z), and a strip in which
/// the note at the shown time is read, written and deleted. Each change is written at once.
class NoteControl : public QObject {
 public:
  struct Actions {
    std::function<std::optional<NoteMoment>()> moment;  ///< what is shown now, held still; nothing: no session
    std::function<void()> changed;
    std::function<void(const QString& text, bool problem)> notify;
  };

  /// View and panel must outlive the control.
  NoteControl(FeedView& feed, FeedPanel& panel, Actions actions);
  ~NoteControl() override;

  /// Both belong to the widgets that they are put into.
  QFrame& strip() noexcept { return *strip_; }
  QPushButton& button() noexcept { return *button_; }

  /// Annotations that can't be read are left alone, and said.
  void set_session(const std::filesystem::path& folder, double pixel_size_um);
  double pixel_size_um() const noexcept { return pixel_size_um_; }
  /// Whether a note can be made now; says why where it can't.
  bool ready();
  /// Adds a note at the time shown; its own time is left out of account.
  void keep(Annotation note);
  /// The note at that time in the strip, which hides without one.
  void show_at(double time_s);
  const std::vector<Annotation>& notes() const noexcept;
  /// Marks on the image for the notes at that time that have a place.
  std::vector<HintMark> marks_at(double time_s) const;
  /// A note in the list of events: its words, then its node or place.
  std::string listed(const Annotation& note) const;

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  void build_button();
  void build_strip();
  void wait_for_click(bool waits);
  void begin(std::optional<Eigen::Vector2d> place_um);
  void write();
  void remove();
  void show_note();
  void leaf(int by);
  void step_back(bool forwards);
  void attempt(const std::function<void()>& change);

  FeedView& feed_;
  FeedPanel& panel_;
  Actions actions_;
  std::unique_ptr<NoteBook> book_;
  std::optional<Annotation> draft_;   // being written for the first time
  std::optional<std::size_t> shown_;  // of the book, in the strip
  double shown_s_ = 0.0;
  double pixel_size_um_ = 0.0;
  std::string prompt_;
  bool waits_ = false;
  bool swallows_release_ = false;
  QFrame* strip_ = nullptr;
  QLabel* where_ = nullptr;
  QLineEdit* text_ = nullptr;
  QPushButton* delete_ = nullptr;
  QPushButton* next_ = nullptr;
  QPushButton* button_ = nullptr;
};

}  // namespace pellucida
