// What the buttons of the window in Review mode do, and what is dropped on it.
#include "CellsWindow.h"
#include "ComparisonReview.h"
#include "HintControl.h"
#include "HintReview.h"
#include "NodeReview.h"
#include "ReviewExport.h"
#include "ReviewViews.h"
#include "ReviewWindow.h"
#include "VideoExport.h"
#include "Words.h"
#include "pellucida/notes/MeasureControl.h"
#include "pellucida/notes/NoteControl.h"
#include "presenters/SeenTables.h"
#include "presenters/TimelinePresenter.h"
#include "widgets/ComparePanel.h"
#include "widgets/CurvePanel.h"
#include "widgets/EventPanel.h"
#include "widgets/FeedPanel.h"
#include "widgets/MembranePanel.h"
#include "widgets/NodePanel.h"
#include "widgets/ReviewBar.h"
#include "widgets/TaskLine.h"
#include "widgets/TimelineBar.h"
#include "widgets/TransportBar.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QSplitter>
#include <QUrl>
#include <algorithm>
#include <cmath>

namespace pellucida {

ReviewBar* ReviewWindow::build_bar() {
  ReviewBar::Actions actions;
  actions.open = [this] { ask_for_session(); };
  actions.export_window = [this] { export_->save_window(*this); };
  actions.export_feed = [this] { export_->save_view(views_->feed().view(), "microscope"); };
  actions.export_view = [this] { export_->save_view(views_->membranes().view(), "3d"); };
  actions.export_time = [this] {
    export_->save_chart(views_->force_over_time().chart(), words("Force over time"), "force-time");
  };
  actions.export_touch = [this] {
    const CurveChart& chart = views_->force_over_indentation().chart();
    const auto quantity = views_->histogram();
    if (!quantity) return export_->save_chart(chart, words("Force over indentation"), "force-indentation");
    export_->save_chart(chart, QString::fromStdString(name_of(*quantity)), "histogram",
                        [this](const auto& file) { write_histogram(views_->sample(), file); });
  };
  actions.export_node = [this] {
    export_->save_chart(node_->panel().curve().chart(), words("Node %1").arg(node_->node().value_or(0)), "node");
  };
  actions.export_video = [this] {
    const std::filesystem::path file = export_->ask_for_video();
    const double step_s = session_->usual_step_s();
    if (!file.empty()) video_->start(file, session_->step_count(), step_s > 0.0 ? 1.0 / step_s : 1.0);
  };
  actions.export_tables = [this] { export_->save_tables(); };
  actions.export_seen = [this] { export_seen(); };
  actions.report = [this] { export_->report(); };
  actions.compare = [this](bool on) {
    const std::filesystem::path folder =
        on ? choice_.session(words("Compare with a session")) : std::filesystem::path();
    folder.empty() ? clear_comparison() : compare(folder);
  };
  actions.cells = [this] { show_cells(); };
  actions.show_events = [this](bool on) { side_->setVisible(on); };
  return new ReviewBar(actions, nullptr);
}

void ReviewWindow::export_seen() {
  if (!shown_step_) return;
  SeenFrame frame;
  frame.row = session_->rows[*shown_step_];
  const auto surface = shown_.surface.shallow_copy();
  frame.surface = surface;
  frame.node = node_->node();
  frame.charts.push_back({"force-time", views_->force_over_time().chart().data()});
  frame.charts.push_back(
      {views_->histogram() ? "histogram" : "force-indentation", views_->force_over_indentation().chart().data()});
  if (node_->node()) frame.charts.push_back({"node", node_->panel().curve().chart().data()});
  if (comparison_->active()) frame.charts.push_back({"difference", comparison_->panel().curve().chart().data()});
  export_->save_seen(frame);
}

// A window beside this one, made when it is first asked for; it begins with the session shown.
void ReviewWindow::show_cells() {
  if (!cells_) {
    cells_ = new CellsWindow(
        choice_,
        [this](const std::filesystem::path& folder, double time_s) {
          options_.from_s = std::isfinite(time_s) ? std::optional(time_s) : std::nullopt;
          open(folder);
        },
        this);
    if (session_) cells_->add(session_->folder);
  }
  cells_->show();
  cells_->raise();
  cells_->activateWindow();
}

void ReviewWindow::build_hints() {
  HintReview::Actions actions;
  actions.notify = [this](const QString& text, bool problem) { notify(text, problem); };
  actions.work = [this](const QString& text, std::size_t done, std::size_t all) {
    if (task_line_) task_line_->show_work(text, done, all);
  };
  actions.open = [this](const std::filesystem::path& folder) {
    options_.from_s = session_->times_s[playback_.step()];
    open(folder);
  };
  actions.changed = [this] {
    if (views_ && session_) show_hint_marks();
  };
  hints_ = new HintReview(std::move(actions), this);
}

void ReviewWindow::build_video() {
  VideoExport::Actions actions;
  actions.go_to = [this](std::size_t step) {
    playback_.play(false, clock_->now_s());
    if (playback_.step() != step || shown_step_ != step) go_to(step);
  };
  actions.notify = [this](const QString& text, bool problem) { notify(text, problem); };
  actions.work = [this](const QString& text, std::size_t done, std::size_t all) {
    task_line_->show_work(text, done, all);
  };
  video_ = new VideoExport(*views_, std::move(actions), this);
}

// A hint belongs to the frame it was given on: the one shown, which stays.
void ReviewWindow::add_hint_control() {
  hint_control_ = new HintControl(views_->image(), views_->feed(),
                                  {[this](const PersonHint& hint) {
                                     if (!session_ || !shown_step_) return;
                                     playback_.play(false, clock_->now_s());
                                     hints_->add(hint, session_->times_s[*shown_step_]);
                                   },
                                   [this] { hints_->take_back(); },
                                   [this] {
                                     if (session_) show_hint_marks();
                                   },
                                   [this](const QString& text, bool problem) { notify(text, problem); }});
}

void ReviewWindow::show_hint_marks() {
  if (!shown_step_) return;
  const double time_s = session_->times_s[*shown_step_];
  std::vector<HintMark> marks = hints_->draft().marks_at(time_s);
  const std::vector<HintMark> notes = notes_->marks_at(time_s);
  marks.insert(marks.end(), notes.begin(), notes.end());
  const std::vector<HintMark> measured = measures_->marks();
  marks.insert(marks.end(), measured.begin(), measured.end());
  if (hint_control_) {
    const std::vector<HintMark> drawn = hint_control_->marks();
    marks.insert(marks.end(), drawn.begin(), drawn.end());
  }
  views_->mark_hints(std::move(marks));
}

void ReviewWindow::build_notes() {
  NoteControl::Actions actions;
  actions.moment = [this]() -> std::optional<NoteMoment> {
    if (!session_ || !shown_step_) return std::nullopt;
    playback_.play(false, clock_->now_s());
    return NoteMoment{session_->times_s[*shown_step_], node_->node()};
  };
  actions.changed = [this] {
    if (session_) list_events();
  };
  actions.notify = [this](const QString& text, bool problem) { notify(text, problem); };
  notes_ = new NoteControl(views_->image(), views_->feed(), std::move(actions));
  measures_ = new MeasureControl(views_->image(), views_->feed(), *notes_,
                                 {[this] {
                                    if (session_) show_hint_marks();
                                  },
                                  [this] {
                                    if (!session_) return;
                                    export_->save_table(words("Distances and angles"), "measured",
                                                        [this](const auto& file) { measures_->write(file); });
                                  }});
}

// The session's events and doubts with the notes about them, in the list and on the timeline.
void ReviewWindow::list_events() {
  events_ = review_events(*session_);
  for (const Annotation& note : notes_->notes()) {
    events_.push_back({note.time_s, kAnnotationKind, notes_->listed(note), note.time_s, false});
  }
  std::stable_sort(events_.begin(), events_.end(), [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
  timeline_->set_timeline(timeline_of(*session_, events_));
  event_panel_->set_events(events_);
  show_hint_marks();
}

TransportBar* ReviewWindow::build_transport() {
  TransportBar::Actions actions;
  actions.toggle_play = [this] {
    playback_.play(!playback_.playing(), clock_->now_s());
    follow();
  };
  actions.step_by = [this](long count) {
    playback_.step_by(count);
    follow();
  };
  actions.to_event = [this](bool forwards) {
    if (session_) go_to(neighbour_event_step(*session_, events_, playback_.step(), forwards));
  };
  actions.to_end = [this](bool last) { go_to(last ? playback_.step_count() - 1 : 0); };
  actions.set_speed = [this](double ratio) {
    playback_.set_speed_ratio(ratio, clock_->now_s());
    show_place();
  };
  actions.set_loop = [this](bool on) { playback_.set_loop(on); };
  actions.set_backwards = [this](bool on) { playback_.set_backwards(on, clock_->now_s()); };
  return new TransportBar(std::move(actions), nullptr);
}

void ReviewWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (!urls.empty() && std::all_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); })) {
    event->acceptProposedAction();
  }
}

// One session is opened, of several the cells are put into their table.
void ReviewWindow::dropEvent(QDropEvent* event) {
  std::vector<std::filesystem::path> dropped;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (!url.isLocalFile()) return;
    dropped.emplace_back(url.toLocalFile().toStdString());
    // One of a session's files means its session.
    if (std::filesystem::is_regular_file(dropped.back())) dropped.back() = dropped.back().parent_path();
  }
  if (dropped.empty()) return;
  event->acceptProposedAction();
  if (dropped.size() == 1) return open(dropped.front());
  show_cells();
  for (const auto& folder : dropped) cells_->add(folder);
}

}  // namespace pellucida
