#include "ReviewWindow.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "NodeReview.h"
#include "ReviewExport.h"
#include "ReviewViews.h"
#include "presenters/ReadoutPresenter.h"
#include "presenters/SessionCurves.h"
#include "presenters/TimelinePresenter.h"
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
constexpr const char* kHint =
    "Space plays, arrow keys step, a press on the timeline or on force over time seeks, a click on the membrane picks "
    "a "
    "node";

}  // namespace

// A session and what follows from its tables, made on the thread that reads it.
struct ReviewWindow::Opened {
  std::unique_ptr<RecordedSession> session;
  std::vector<ReviewEvent> events;
  Timeline timeline;
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
  node_->clear();
  loader_.reset();
  // The widgets show the views: they go first.
  delete takeCentralWidget();
}

void ReviewWindow::build() {
  setWindowTitle("Pellucida - Review");
  setWindowIcon(make_icon(Pictogram::kProgram));
  resize(options_.width_px, options_.height_px);
  setMinimumSize(1000, 640);
  setAcceptDrops(true);
  connect(new QShortcut(QKeySequence::Quit, this), &QShortcut::activated, this, [this] { close(); });

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
  pages_ = new QStackedWidget;
  pages_->addWidget(open_page_ = new OpenPage([this] { ask_for_session(); }, nullptr));
  pages_->addWidget(build_session_page());
  column->addWidget(bar_ = build_bar());
  column->addWidget(pages_, 1);
  column->addWidget(task_line_ = new TaskLine([this] { export_->cancel(); }, page));
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
  views_ = new ReviewViews(
      to_time, [this](long node) { choose_node(node); }, nullptr);
  node_ = new NodeReview(
      to_time, [this] { clear_node(); }, this);
  side_ = new QSplitter(Qt::Vertical);
  side_->setHandleWidth(4);
  side_->setChildrenCollapsible(false);
  side_->addWidget(event_panel_ = new EventPanel(to_time, nullptr));
  side_->addWidget(&node_->panel());
  side_->setStretchFactor(0, 1);
  side_->setStretchFactor(1, 2);

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
  column->addWidget(timeline_ = new TimelineBar(to_time, page));
  column->addWidget(transport_ = build_transport());
  return page;
}

ReviewBar* ReviewWindow::build_bar() {
  ReviewBar::Actions actions;
  actions.open = [this] { ask_for_session(); };
  actions.export_window = [this] { export_->save_window(*this); };
  actions.export_feed = [this] { export_->save_view(views_->feed().view(), "microscope"); };
  actions.export_view = [this] { export_->save_view(views_->membranes().view(), "3d"); };
  actions.export_time = [this] {
    export_->save_chart(views_->force_over_time().chart(), "Force over time", "force-time");
  };
  actions.export_touch = [this] {
    export_->save_chart(views_->force_over_indentation().chart(), "Force over indentation", "force-indentation");
  };
  actions.export_node = [this] {
    export_->save_chart(node_->panel().curve().chart(), QString("Node %1").arg(node_->node().value_or(0)), "node");
  };
  actions.export_tables = [this] { export_->save_tables(); };
  actions.report = [this] { export_->report(); };
  actions.show_events = [this](bool on) { side_->setVisible(on); };
  return new ReviewBar(actions, nullptr);
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

void ReviewWindow::ask_for_session() {
  const std::filesystem::path folder = choice_.session();
  if (!folder.empty()) open(folder);
}

void ReviewWindow::open(const std::filesystem::path& folder) {
  if (opening_.running()) {
    notify("Wait: a session is being opened", true);
    return;
  }
  const QString name = QString::fromStdString(folder.string());
  open_page_->show_reading(name);
  task_line_->show_notice({"Opening " + folder.string(), palette::kTextDim});
  opening_.run(
      [this, folder](const BackgroundTask::Control&) -> std::function<void()> {
        SessionReader reader(folder);
        auto opened = std::make_shared<Opened>();
        opened->session = std::make_unique<RecordedSession>(recorded_session(reader));
        opened->events = review_events(*opened->session);
        opened->timeline = timeline_of(*opened->session, opened->events);
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
  export_->set_session(opened.session->folder);
  loader_ = std::move(opened.loader);
  events_ = std::move(opened.events);
  // The views hold on to the session before: they are given the new one first.
  const auto before = std::exchange(session_, std::move(opened.session));
  views_->set_session(*session_);
  timeline_->set_timeline(std::move(opened.timeline));
  event_panel_->set_events(events_);
  bar_->show_session(session_.get());
  setWindowTitle("Pellucida - Review of " + QString::fromStdString(session_name_of(session_->folder)));
  open_page_->show_problem({});
  pages_->setCurrentIndex(1);

  since_charts_.start();
  const double now_s = clock_->now_s();
  playback_ = Playback(session_->times_s);
  playback_.set_speed_ratio(options_.speed_ratio, now_s);
  playback_.set_loop(options_.loop);
  playback_.set_backwards(options_.backwards, now_s);
  shown_step_.reset();
  playback_.go_to_time(options_.from_s.value_or(session_->begin_s()), now_s);
  follow();
  const std::string caution = session_caution(*session_);
  if (caution.empty()) {
    task_line_->show_notice({});
    since_notice_.invalidate();
  } else {
    notify(QString::fromStdString(caution), true);
  }
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
  readouts_->show_texts(readout_texts(&shown_, session_->profile));
  views_->show_step(shown_, loaded.step);
  node_->show_step(shown_);
  event_panel_->set_position_s(session_->times_s[loaded.step]);
  charts_due_ = true;
  show_place();
}

void ReviewWindow::draw_charts() {
  views_->draw_charts();
  node_->draw_chart();
  charts_due_ = false;
  since_charts_.start();
}

void ReviewWindow::show_place() {
  if (!session_) return;
  timeline_->set_position_s(playback_.playing() ? playback_.position_s() : session_->times_s[playback_.step()]);
  transport_->show_state(playback_, session_->rows[playback_.step()].frame);
}

void ReviewWindow::show_notice() {
  if (since_notice_.isValid() && since_notice_.elapsed() < kReviewNotice_ms) return;
  since_notice_.invalidate();
  if (!step_error_.empty()) {
    task_line_->show_notice({step_error_, palette::kRecord});
  } else {
    const Phrase doubt = force_notice(shown_);
    task_line_->show_notice(doubt.text.empty() ? Phrase{kHint, palette::kTextDim} : doubt);
  }
}

void ReviewWindow::notify(const QString& text, bool problem) {
  task_line_->show_notice({text.toStdString(), problem ? palette::kWarning : palette::kAccent});
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

// A low window has room for one of the two.
void ReviewWindow::arrange_side() {
  event_panel_->setVisible(!node_->node() || height() >= kRoomForBoth_px);
}

void ReviewWindow::resizeEvent(QResizeEvent*) {
  if (node_) arrange_side();
}

void ReviewWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void ReviewWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (urls.size() != 1 || !urls.front().isLocalFile()) return;
  event->acceptProposedAction();
  std::filesystem::path dropped = urls.front().toLocalFile().toStdString();
  // One of a session's files means its session.
  if (std::filesystem::is_regular_file(dropped)) dropped = dropped.parent_path();
  open(dropped);
}

}  // namespace pellucida
