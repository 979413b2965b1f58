#pragma once
#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>

#include "BackgroundTask.h"
#include "FileChoice.h"
#include "TimedScreenshot.h"
#include "pellucida/core/Clock.h"
#include "pellucida/review/Review.h"
#include "presenters/Playback.h"
#include "presenters/RecordedSession.h"
#include "presenters/ReviewEvents.h"
#include "presenters/StepLoader.h"

class QSplitter;
class QStackedWidget;

namespace pellucida {

class CellsWindow;
class ComparisonReview;
class EventPanel;
class HintControl;
class HintReview;
class NodeReview;
class MeasureControl;
class NoteControl;
class OpenPage;
class ReadoutBar;
class ReviewBar;
class ReviewExport;
class ReviewViews;
class TaskLine;
class ThumbnailBar;
class TimelineBar;
class TransportBar;
class VideoExport;

/// The workstation's window in Review mode: a recorded session with its views, charts, events and timeline. What it
/// shows was recorded; nothing is computed anew. Sessions are opened and steps read on threads of their own; a timer
/// shows the newest step read, everywhere at once. A session that can't be read leaves the window as it was, with the
/// reason.
class ReviewWindow : public QMainWindow {
 public:
  /// `clock`: what playing follows; `choice`: who is asked for files, by default Qt's dialogs.
  explicit ReviewWindow(ReviewOptions options, std::shared_ptr<const Clock> clock = std::make_shared<SteadyClock>(),
                        std::optional<FileChoice> choice = std::nullopt);
  ~ReviewWindow() override;

  /// Opens the session in `folder` in the background, in place of the present one.
  void open(const std::filesystem::path& folder);
  /// Compares the present session with the one in `folder`, in place of the one before.
  void compare(const std::filesystem::path& folder);
  /// Nothing before one was opened.
  const RecordedSession* session() const noexcept { return session_.get(); }
  const Playback& playback() const noexcept { return playback_; }
  /// The step that the views show; nothing before the first.
  std::optional<std::size_t> shown_step() const noexcept { return shown_step_; }
  const ReviewViews& views() const noexcept { return *views_; }
  const NodeReview& node() const noexcept { return *node_; }
  const ComparisonReview& comparison() const noexcept { return *comparison_; }
  /// Null before it was asked for.
  CellsWindow* cells() const noexcept { return cells_; }
  const HintReview& hints() const noexcept { return *hints_; }

  const TimedScreenshot& screenshot() const noexcept { return *screenshot_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Opened;

  void build();
  void build_hints();
  void build_notes();
  void list_events();
  void build_video();
  void add_hint_control();
  void show_hint_marks();
  QWidget* build_session_page();
  ReviewBar* build_bar();
  TransportBar* build_transport();
  void ask_for_session();
  void adopt(Opened& opened);
  void refuse(const QString& problem);

  void tick();
  void go_to(std::size_t step);
  void seek(double time_s);
  void follow();
  void show_step(const LoadedStep& loaded);
  void draw_charts();
  void arrange_side();
  void show_place();
  void show_notice();
  void notify(const QString& text, bool problem);
  void choose_node(long node);
  void clear_node();
  void clear_comparison();
  void show_cells();
  void export_seen();

  ReviewOptions options_;
  std::shared_ptr<const Clock> clock_;
  FileChoice choice_;
  std::unique_ptr<RecordedSession> session_;
  std::vector<ReviewEvent> events_;
  std::unique_ptr<StepLoader> loader_;
  Playback playback_;
  std::optional<std::size_t> shown_step_;
  Scene shown_;
  std::string step_error_;

  QStackedWidget* pages_ = nullptr;
  OpenPage* open_page_ = nullptr;
  ReviewBar* bar_ = nullptr;
  ReadoutBar* readouts_ = nullptr;
  ReviewViews* views_ = nullptr;
  QSplitter* side_ = nullptr;
  EventPanel* event_panel_ = nullptr;
  TimelineBar* timeline_ = nullptr;
  ThumbnailBar* thumbnails_ = nullptr;
  TransportBar* transport_ = nullptr;
  TaskLine* task_line_ = nullptr;
  NodeReview* node_ = nullptr;
  NoteControl* notes_ = nullptr;
  MeasureControl* measures_ = nullptr;
  CellsWindow* cells_ = nullptr;
  ComparisonReview* comparison_ = nullptr;
  HintReview* hints_ = nullptr;
  HintControl* hint_control_ = nullptr;
  ReviewExport* export_ = nullptr;
  VideoExport* video_ = nullptr;

  QTimer timer_;
  QElapsedTimer since_charts_;  // since the charts were drawn
  bool charts_due_ = false;     // they show an earlier step than the views
  QElapsedTimer since_notice_;
  BackgroundTask opening_;
  std::unique_ptr<TimedScreenshot> screenshot_;
};

}  // namespace pellucida
