#include "ReviewWindow.h"

#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ComparisonReview.h"
#include "HintReview.h"
#include "NodeReview.h"
#include "ReviewExport.h"
#include "ReviewViews.h"
#include "VideoExport.h"
#include "Words.h"
#include "pellucida/notes/MeasureControl.h"
#include "pellucida/notes/NoteControl.h"
#include "presenters/ReadoutPresenter.h"
#include "presenters/ScalePresenter.h"
#include "presenters/SessionCurves.h"
#include "presenters/TimelinePresenter.h"
#include "widgets/ButtonKey.h"
#include "widgets/ComparePanel.h"
#include "widgets/CurvePanel.h"
#include "widgets/EventPanel.h"
#include "widgets/FeedPanel.h"
#include "widgets/Icons.h"
#include "widgets/MembranePanel.h"
#include "widgets/NodePanel.h"
#include "widgets/OpenPage.h"
#include "widgets/ReadoutBar.h"
#include "widgets/ReviewBar.h"
#include "widgets/TaskLine.h"
#include "widgets/ThumbnailBar.h"
#include "widgets/TimelineBar.h"
#include "widgets/TransportBar.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr int kReviewTick_ms = 33;
// While playing, the charts' cursors move no more often than this.
constexpr int kChartPeriod_ms = 100;
constexpr int kReviewNotice_ms = 6000;
// Narrower than this the list beside the views would take their place: it is opened on demand.
constexpr int kRoomForEvents_px = 1200;
// Lower than this the node takes the place of the list.
constexpr int kRoomForBoth_px = 780;
// Lower than this the views need the room.
constexpr int kRoomForThumbnails_px = 720;
constexpr const char* kHint = PELLUCIDA_WORDS(
    "Space plays, arrow keys step, a press on the timeline or on force over time seeks, a click on the membrane picks "
    "a node");

}  // namespace

// A session and what follows from its tables, made on the thread that reads it.
struct ReviewWindow::Opened {
  std::unique_ptr<RecordedSession> session;
  std::unique_ptr<StepLoader> loader;
};

ReviewWindow::ReviewWindow(ReviewOptions options, std::shared_ptr<const Clock> clock, std::optional<FileChoice> choice)
    : options_(std::move(options)),
      clock_(std::move(clock)),
      choice_(choice ? std::move(*choice) : dialogs_over(*this)) {
  build();
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  timer_.start(0);
  // What is on screen may lag behind by a tick or two: views, then charts.
  screenshot_ = std::make_unique<TimedScreenshot>(*this, options_, [this] {
    tick();
    if (charts_due_) draw_charts();
  });
}

ReviewWindow::~ReviewWindow() {
  timer_.stop();
  opening_.cancel();
  export_->cancel();
  hints_->set_session(nullptr);
  node_->clear();
  comparison_->clear();
  loader_.reset();
  // The widgets show the views: they go first.
  delete takeCentralWidget();
}

void ReviewWindow::build() {
  setWindowTitle(words("Pellucida - Review"));
  setWindowIcon(make_icon(Pictogram::kProgram));
  resize(options_.width_px, options_.height_px);
  setMinimumSize(1000, 640);
  setAcceptDrops(true);
  add_window_key(*this, QKeySequence::Quit, words("Close the window"), [this] { close(); });

  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  export_ = new ReviewExport(
      choice_, [this](const QString& text, bool problem) { notify(text, problem); },
      [this](const QString& text, std::size_t done, std::size_t all) {
        if (task_line_) task_line_->show_work(text, done, all);
      },
      this);
  bar_ = build_bar();
  pages_ = new QStackedWidget;
  pages_->addWidget(open_page_ = new OpenPage([this] { ask_for_session(); }, nullptr));
  pages_->addWidget(build_session_page());
  column->addWidget(bar_);
  column->addWidget(pages_, 1);
  column->addWidget(task_line_ = new TaskLine(
                        [this] {
                          export_->cancel();
                          hints_->cancel();
                          video_->cancel();
                        },
                        page));
  setCentralWidget(page);
  bar_->show_events(options_.width_px >= kRoomForEvents_px);
}

QWidget* ReviewWindow::build_session_page() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(readouts_ = new ReadoutBar(page));
  const auto to_time = [this](double time_s) { seek(time_s); };
  build_hints();
  column->addWidget(&hints_->strip());
  views_ = new ReviewViews(
      to_time, [this](long node) { choose_node(node); }, nullptr);
  add_hint_control();
  build_notes();
  column->addWidget(&notes_->strip());
  bar_->add(notes_->button());
  bar_->add(measures_->button());
  build_video();
  node_ = new NodeReview(
      to_time, [this] { clear_node(); }, this);
  side_ = new QSplitter(Qt::Vertical);
  side_->setHandleWidth(4);
  side_->setChildrenCollapsible(false);
  side_->addWidget(event_panel_ = new EventPanel(to_time, nullptr));
  side_->addWidget(&node_->panel());
  comparison_ = new ComparisonReview(
      *views_, *export_, [this] { clear_comparison(); }, [this](const QString& problem) { notify(problem, true); },
      this);
  side_->addWidget(&comparison_->panel());
  side_->setStretchFactor(0, 1);
  side_->setStretchFactor(1, 2);
  side_->setStretchFactor(2, 4);

  auto* all = new QSplitter(Qt::Horizontal);
  all->setHandleWidth(4);
  all->setChildrenCollapsible(false);
  all->addWidget(views_);
  all->addWidget(side_);
  all->setStretchFactor(0, 1);
  all->setStretchFactor(1, 0);
  const int side_px = std::clamp(options_.width_px / 4, 250, 380);
  all->setSizes({options_.width_px - side_px, side_px});
  column->addSpacing(4);
  column->addWidget(all, 1);
  column->addSpacing(4);
  timeline_ = new TimelineBar(to_time, page);
  column->addWidget(thumbnails_ = new ThumbnailBar(*timeline_, to_time, page));
  column->addWidget(timeline_);
  column->addWidget(transport_ = build_transport());
  return page;
}

void ReviewWindow::ask_for_session() {
  const std::filesystem::path folder = choice_.session(words("Open a session"));
  if (!folder.empty()) open(folder);
}

void ReviewWindow::open(const std::filesystem::path& folder) {
  if (opening_.running()) {
    notify(words("Wait: a session is being opened"), true);
    return;
  }
  const QString name = QString::fromStdString(folder.string());
  open_page_->show_reading(name);
  task_line_->show_notice({std::string(words("Opening ")) + folder.string(), current_theme().text_dim});
  opening_.run(
      [this, folder](const BackgroundTask::Control&) -> std::function<void()> {
        SessionReader reader(folder);
        auto opened = std::make_shared<Opened>();
        opened->session = std::make_unique<RecordedSession>(recorded_session(reader));
        opened->loader = std::make_unique<StepLoader>(std::move(reader));
        return [this, opened] { adopt(*opened); };
      },
      {}, [this](const std::string& error) { refuse(QString::fromStdString(error)); });
}

void ReviewWindow::refuse(const QString& problem) {
  open_page_->show_problem(problem);
  task_line_->show_notice({});
  if (session_) notify(problem, true);
}

void ReviewWindow::adopt(Opened& opened) {
  clear_node();
  clear_comparison();
  video_->cancel();
  export_->set_session(opened.session->folder);
  hints_->set_session(opened.session.get());
  loader_ = std::move(opened.loader);
  shown_step_.reset();
  // The views hold on to the session before: they are given the new one first.
  const auto before = std::exchange(session_, std::move(opened.session));
  thumbnails_->set_session(nullptr);
  views_->set_session(*session_);
  const std::string caution = session_caution(*session_);
  if (caution.empty()) {
    task_line_->show_notice({});
    since_notice_.invalidate();
  } else {
    notify(QString::fromStdString(caution), true);
  }
  // What keeps the notes from being read is said last, and stays.
  notes_->set_session(session_->folder, session_->info.source.pixel_size_um);
  thumbnails_->set_session(session_.get());
  bar_->show_session(session_.get());
  setWindowTitle(words("Pellucida - Review of ") + QString::fromStdString(session_name_of(session_->folder)));
  open_page_->show_problem({});
  pages_->setCurrentIndex(1);

  since_charts_.start();
  const double now_s = clock_->now_s();
  playback_ = Playback(session_->times_s);
  playback_.set_speed_ratio(options_.speed_ratio, now_s);
  playback_.set_loop(options_.loop);
  playback_.set_backwards(options_.backwards, now_s);
  playback_.go_to_time(std::exchange(options_.from_s, std::nullopt).value_or(session_->begin_s()), now_s);
  follow();
  if (!options_.compare.empty()) compare(std::exchange(options_.compare, {}));
}

void ReviewWindow::go_to(std::size_t step) {
  playback_.go_to(step, clock_->now_s());
  follow();
}

void ReviewWindow::seek(double time_s) {
  playback_.go_to_time(time_s, clock_->now_s());
  follow();
}

// The playback has moved: its step is read, and shown once it is there.
void ReviewWindow::follow() {
  if (!session_) return;
  loader_->request(playback_.step());
  show_place();
}

void ReviewWindow::tick() {
  QElapsedTimer spent;
  spent.start();
  if (session_) {
    const bool was_playing = playback_.playing();
    if (playback_.tick(clock_->now_s())) loader_->request(playback_.step());
    // Views and charts in turns: together they would keep the mouse waiting.
    if (charts_due_ && (!playback_.playing() || since_charts_.elapsed() >= kChartPeriod_ms)) {
      draw_charts();
    } else if (const auto loaded = loader_->take()) {
      show_step(*loaded);
    }
    if (comparison_->tick() || views_->charts_changed()) charts_due_ = true;
    if (shown_step_ && !charts_due_) video_->shown(*shown_step_);
    if (was_playing) show_place();
    show_notice();
  }
  // A slow renderer must leave time for the mouse and the other threads.
  const int spent_ms = static_cast<int>(spent.elapsed());
  timer_.start(std::max(kReviewTick_ms - spent_ms, spent_ms / 3));
}

// All of the window that shows a step, in one go.
void ReviewWindow::show_step(const LoadedStep& loaded) {
  shown_ = loaded.scene;
  shown_step_ = loaded.step;
  step_error_ = loaded.error;
  shown_.remarks.warning = doubts_at(events_, session_->times_s[loaded.step]);
  add_scale(*session_, session_->rows[loaded.step], shown_.remarks);
  readouts_->show_texts(readout_texts(&shown_, session_->profile));
  readouts_->show_scale(scale_texts(&shown_, session_->profile));
  notes_->show_at(session_->times_s[loaded.step]);
  show_hint_marks();
  views_->show_step(shown_, loaded.step);
  node_->show_step(shown_);
  comparison_->show_step(loaded.step);
  event_panel_->set_position_s(session_->times_s[loaded.step]);
  charts_due_ = true;
  show_place();
}

void ReviewWindow::draw_charts() {
  views_->draw_charts();
  node_->draw_chart();
  comparison_->draw_chart();
  charts_due_ = false;
  since_charts_.start();
}

void ReviewWindow::show_place() {
  if (!session_) return;
  const double time_s = playback_.playing() ? playback_.position_s() : session_->times_s[playback_.step()];
  timeline_->set_position_s(time_s);
  thumbnails_->set_position_s(time_s);
  transport_->show_state(playback_, session_->rows[playback_.step()].frame);
}

void ReviewWindow::show_notice() {
  if (since_notice_.isValid() && since_notice_.elapsed() < kReviewNotice_ms) return;
  since_notice_.invalidate();
  if (!step_error_.empty()) {
    task_line_->show_notice({step_error_, current_theme().record});
  } else {
    const Phrase doubt = force_notice(shown_);
    task_line_->show_notice(doubt.text.empty() ? Phrase{words(kHint), current_theme().text_dim} : doubt);
  }
}

void ReviewWindow::notify(const QString& text, bool problem) {
  task_line_->show_notice({text.toStdString(), problem ? current_theme().warning : current_theme().accent});
  since_notice_.start();
}

void ReviewWindow::choose_node(long node) {
  if (!session_) return;
  bar_->show_events(true);
  views_->mark_node(node);
  node_->choose(session_->folder, node);
  node_->show_step(shown_);
  bar_->set_node_chosen(true);
  arrange_side();
  charts_due_ = true;
}

void ReviewWindow::clear_node() {
  node_->clear();
  views_->mark_node(std::nullopt);
  bar_->set_node_chosen(false);
  arrange_side();
}

void ReviewWindow::compare(const std::filesystem::path& folder) {
  if (!session_) return;
  // The newest choice has the room.
  clear_node();
  bar_->show_events(true);
  bar_->set_comparing(true);
  comparison_->choose(*session_, folder);
  if (shown_step_) comparison_->show_step(*shown_step_);
  arrange_side();
}

void ReviewWindow::clear_comparison() {
  comparison_->clear();
  bar_->set_comparing(false);
  arrange_side();
  charts_due_ = true;
}

// A low window has room for one of events and node; a comparison takes the place of both but for a node picked since.
void ReviewWindow::arrange_side() {
  const bool compares = comparison_->active() && !node_->node();
  comparison_->panel().setVisible(compares);
  event_panel_->setVisible(!compares && (!node_->node() || height() >= kRoomForBoth_px));
}

void ReviewWindow::resizeEvent(QResizeEvent*) {
  if (comparison_) arrange_side();
  if (thumbnails_) thumbnails_->set_room(height() >= kRoomForThumbnails_px);
}

}  // namespace pellucida
