#include "GuideWindow.h"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "CellControl.h"
#include "DisplayControl.h"
#include "ExposureControl.h"
#include "HandControl.h"
#include "HintControl.h"
#include "PlanControl.h"
#include "RunControl.h"
#include "Words.h"
#include "pellucida/operation/ProfileStrength.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/HintDraft.h"
#include "presenters/MessageBook.h"
#include "presenters/ReadoutPresenter.h"
#include "presenters/ScalePresenter.h"
#include "presenters/SourcePresenter.h"
#include "widgets/ButtonKey.h"
#include "widgets/CellDrawer.h"
#include "widgets/FactLine.h"
#include "widgets/FeedPanel.h"
#include "widgets/ForceCharts.h"
#include "widgets/GaugeBar.h"
#include "widgets/HandBar.h"
#include "widgets/Icons.h"
#include "widgets/KeySheet.h"
#include "widgets/MembranePanel.h"
#include "widgets/MessageStrip.h"
#include "widgets/RecordStrip.h"
#include "widgets/StatusLine.h"
#include "widgets/TopBar.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr int kTick_ms = 16;
// After which a tick that found the views still being drawn looks again.
constexpr int kRetry_ms = 4;
constexpr double kStatusPeriod_s = 0.1;
constexpr double kNotice_s = 6.0, kProblem_s = 20.0;
// A window lower than this has smaller gauges.
constexpr int kLow_px = 780;
// A mark of a hint: the needle it points at moves on.
constexpr double kHintMark_s = 2.0;

QString text_of(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

}  // namespace

GuideWindow::GuideWindow(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console, GuideOptions options)
    : run_(std::move(run)),
      console_(std::move(console)),
      options_(std::move(options)),
      scenes_(*run_, source_),
      closing_(*this, [this] { control_->end_recording(); }) {
  feed_.set_caption(source_caption(run_->source_info()));
  control_ = std::make_unique<RunControl>(
      *run_, *this, options_.session_folder,
      [this] {
        cells_->begin_recording();
        control_->remark(display_->words_for_recording());
      },
      [this](const QString& text, bool problem) { problem ? warn(text) : notify(text, false); });
  build();
  clock_.start();
  facts_->show_texts(readout_texts(nullptr, run_->profile()));
  facts_->show_scale(scale_texts(nullptr, run_->profile()));
  show_gauges();
  show_status();
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  timer_.start(0);
  run_->start();
  if (console_ && options_.hand >= 0) console_->choose(options_.hand);
  // What is on screen may lag behind by a tick: all parts once more before the picture.
  screenshot_ = std::make_unique<TimedScreenshot>(*this, options_, [this] {
    scenes_.poll();
    show_scene();
    charts_->render();
    show_status();
  });
}

void GuideWindow::end_run() {
  stop_run();
  run_->rethrow_recording_fault();
}

// The hand first: its last ticks belong to the recording.
void GuideWindow::stop_run() {
  timer_.stop();
  // What acts on the console.
  delete std::exchange(plan_, nullptr);
  delete std::exchange(display_, nullptr);
  hand_.reset();
  console_.reset();
  run_->stop();
}

GuideWindow::~GuideWindow() {
  stop_run();
  // The widgets show the views: they go first.
  delete takeCentralWidget();
}

void GuideWindow::build() {
  setWindowTitle(text_of(window_title(run_->source_info())));
  setWindowIcon(make_icon(Pictogram::kProgram));
  resize(options_.width_px, options_.height_px);
  setMinimumSize(1000, 640);
  add_window_key(*this, QKeySequence::Quit, words("Close the window"), [this] { close(); });

  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(top_bar_ = build_top_bar());
  problem_ = new MessageStrip("problemStrip", {{words("Close"), {}}}, page);
  column->addWidget(problem_);
  column->addWidget(gauges_ = new GaugeBar(page));
  column->addWidget(facts_ = new FactLine(page));
  QSplitter* rows = build_rows();
  build_controls();
  if (hand_) column->addWidget(hand_->bar());
  column->addWidget(cells_->strip());
  auto* middle = new QHBoxLayout;
  middle->setContentsMargins(0, 4, 0, 0);
  middle->setSpacing(4);
  middle->addWidget(rows, 1);
  middle->addWidget(cells_->drawer());
  column->addLayout(middle, 1);
  column->addWidget(status_line_ = new StatusLine(page));
  setCentralWidget(page);
  resizeEvent(nullptr);
}

// What the mouse and the keys do. Of the mouse on the image a later control takes before an earlier one.
void GuideWindow::build_controls() {
  const auto say_it = [this](const QString& text, bool problem) { notify(text, problem); };
  if (console_) {
    hand_ = std::make_unique<HandControl>(*console_, feed_panel_->view(), *this);
    plan_ = new PlanControl(*console_, feed_, *feed_panel_, say_it);
  }
  hints_ = new HintControl(feed_, *feed_panel_,
                           {[this](const PersonHint& hint) { give_hint(hint); }, [this] { control_->take_back_hint(); },
                            [this] { feed_.set_hints(hints_->marks()); }, say_it});
  if (options_.exposure) {
    new ExposureControl(
        options_.exposure, feed_panel_->image_menu(), [this](const std::string& text) { control_->remark(text); },
        say_it);
  }
  cells_ = new CellControl(
      *control_, run_->profile().name, *this, [this] { top_bar_->show_cells(false); },
      [this](const QString& text, bool problem) { problem ? warn(text) : notify(text, false); });
  add_window_key(*this, QKeySequence("Shift+N"), words("Name the cell in view"), [this] { cells_->begin_name(); });
  DisplayControl::Parts parts;
  parts.console = console_.get();
  parts.hand = hand_.get();
  parts.space = membrane_panel_;
  parts.has_truth = static_cast<bool>(options_.true_force_uN);
  parts.remark = [this](const std::string& text) { control_->remark(text); };
  parts.changed = [this] {
    charts_->show_truth(display_->shows_truth());
    scenes_.poll();
    show_scene();
  };
  display_ = new DisplayControl(std::move(parts), top_bar_->display());
}

// Views above, charts below; every border can be dragged.
QSplitter* GuideWindow::build_rows() {
  QSplitter* views = build_views();
  charts_ = new ForceCharts(nullptr);
  auto* all = rows_ = new QSplitter(Qt::Vertical);
  set_sheet_place(*all);
  all->setHandleWidth(4);
  all->setChildrenCollapsible(false);
  all->addWidget(views);
  all->addWidget(charts_);
  // The upright borders are aligned, and stay so.
  for (QSplitter* one : {views, static_cast<QSplitter*>(charts_)}) {
    one->setStretchFactor(0, 1);
    one->setStretchFactor(1, 1);
    one->setSizes({10000, 10000});
  }
  connect(views, &QSplitter::splitterMoved, charts_, [this, views] { charts_->setSizes(views->sizes()); });
  connect(charts_, &QSplitter::splitterMoved, views, [this, views] { views->setSizes(charts_->sizes()); });
  all->setStretchFactor(0, 3);
  all->setStretchFactor(1, 1);
  all->setSizes({520, 250});
  return all;
}

// A low window has smaller gauges and charts, so that the image keeps its room; what a person has dragged stays.
void GuideWindow::resizeEvent(QResizeEvent*) {
  const bool is_low = height() < kLow_px;
  if (!rows_ || is_low == is_low_) return;
  is_low_ = is_low;
  gauges_->set_low(is_low);
  charts_->set_low(is_low);
  rows_->setSizes(is_low ? QList<int>{700, 100} : QList<int>{520, 250});
}

// What was recorded is whole once the run has ended.
void GuideWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(closing_.may_close(run_->status().recording));
}

TopBar* GuideWindow::build_top_bar() {
  // What a button changed is shown at once.
  const auto shown = [this](void (RunControl::*act)()) {
    return [this, act] {
      (control_.get()->*act)();
      show_status();
    };
  };
  TopBar::Actions actions;
  actions.record = shown(&RunControl::toggle_recording);
  actions.pause = shown(&RunControl::toggle_pause);
  if (run_->can_restart()) actions.restart = shown(&RunControl::restart);
  actions.note = [this] { cells_->begin_note(); };
  actions.scale = [this] { control_->ask_for_scale(scenes_.measured()); };
  actions.picture = [this] { control_->save_picture(); };
  actions.cells = [this](bool on) { cells_->drawer()->setVisible(on); };
  return new TopBar(text_of(source_label(run_->source_info())), text_of(run_->source_info().name), std::move(actions),
                    nullptr);
}

QSplitter* GuideWindow::build_views() {
  auto* views = new QSplitter(Qt::Horizontal);
  views->setHandleWidth(4);
  views->setChildrenCollapsible(false);
  views->addWidget(feed_panel_ = new FeedPanel(feed_, nullptr));
  views->addWidget(membrane_panel_ = new MembranePanel(membranes_, nullptr));
  membrane_panel_->setObjectName("space");
  return views;
}

double GuideWindow::now_s() const {
  return 1e-3 * static_cast<double>(clock_.elapsed());
}

void GuideWindow::tick() {
  QElapsedTimer spent;
  spent.start();
  const double begin_s = now_s();
  if (hand_) hand_->tick();
  const bool plan_changed = plan_ && plan_->tick();
  // A scene is drawn before the next one is taken.
  const bool is_drawing = feed_panel_->view().is_waiting() || membrane_panel_->view().is_waiting();
  const bool has_scene = !is_drawing && scenes_.poll();
  if (has_scene) {
    show_scene();
  } else if (plan_changed) {
    feed_panel_->view().render();
  }
  const std::vector<Event> events = take_events();
  const bool is_due = begin_s - status_shown_s_ >= kStatusPeriod_s;
  if (is_due && !has_scene) show_gauges();
  display_->hear(events, gauges_->gauges(), begin_s);
  if (is_due) {
    show_status();
    figures_.look();
    status_shown_s_ = begin_s;
  }
  // The rest of the tick is for the views, each in an event of its own, for the mouse and for the other threads.
  const int spent_ms = static_cast<int>(spent.elapsed());
  timer_.start(is_drawing ? kRetry_ms : std::max(kTick_ms - spent_ms, kRetry_ms));
}

// All of the window that shows a scene, in one go.
void GuideWindow::show_scene() {
  facts_->show_texts(readout_texts(scenes_.measured(), run_->profile()));
  facts_->show_scale(scale_texts(scenes_.measured(), run_->profile()));
  if (scenes_.measured()) seen_speed_um_per_s_ = seen_speed_.update(*scenes_.measured());
  if (scenes_.measured()) cells_->take(*scenes_.measured(), scenes_.new_rows());
  show_gauges();
  feed_.refresh();
  // Handles are the image's alone.
  auto plan = feed_.plan();
  if (plan) plan->has_handles = false;
  membranes_.set_plan(plan);
  if (console_) show_deposits();
  if (membrane_panel_->isVisible()) membranes_.refresh();
  charts_->append(scenes_.new_rows(), options_.true_force_uN);
  feed_panel_->view().render();
  membrane_panel_->view().render();
  ++drawn_count_;
  if (scenes_.measured()) figures_.drew();
}

// What the injector has left in the cell that the plan belongs to.
void GuideWindow::show_deposits() {
  if (!console_->plan()) deposits_.forget();
  const Scene* scene = scenes_.measured();
  const Observation* seen = scene && scene->observation ? &*scene->observation : nullptr;
  deposits_.see(console_->status().pipette,
                scene ? scene->measurement.state.value_or(CellState::kNoCell) : CellState::kNoCell,
                seen && seen->outer ? std::optional(seen->center_um) : std::nullopt, now_s());
  std::vector<DropletMark> marks;
  for (const Droplet& droplet : deposits_.droplets()) {
    marks.push_back({droplet.center_um.eigen(), droplet.radius_um(), readout::number(droplet.volume_pL, 1) + " pL"});
  }
  membranes_.set_droplets(std::move(marks));
}

void GuideWindow::show_gauges() {
  const LiveStatus status = run_->status();
  GaugeInput input;
  input.scene = scenes_.measured();
  input.strength = input.scene ? strength_of(run_->profile(), input.scene->measurement) : strength_of(run_->profile());
  input.limits = limits_of(input.strength);
  input.frame_age_s = 1e-3 * status.frame_age_ms;
  input.is_still = run_->paused() || status.finished;
  input.speed_um_per_s = seen_speed_um_per_s_;
  if (console_) {
    input.has_hand = true;
    input.strength = console_->strength();
    input.limits = console_->limits();
    input.depth_stop_um = console_->depth_stop_um();
    if (console_->plan()) input.plan = &*console_->plan();
    const PipetteState pipette = console_->status().pipette;
    if (pipette.known) {
      input.tip_um = pipette.tip_um.eigen();
      input.speed_um_per_s =
          reported_speed_.update(pipette.time_s, *input.tip_um, way_inwards(input.plan, input.scene));
    } else {
      reported_speed_.forget();
    }
  }
  feed_.set_reported_tip(input.tip_um ? std::optional<Eigen::Vector2d>(input.tip_um->head<2>()) : std::nullopt);
  if (display_->shows_truth() && input.scene) {
    input.true_force_uN = options_.true_force_uN(input.scene->measurement.frame);
  }
  gauges_->show_gauges(make_gauges(input));
}

// What happened since the last tick: a puncture to keep on screen, what came of a hint.
std::vector<Event> GuideWindow::take_events() {
  const std::vector<Event> events = run_->events_since(event_count_);
  event_count_ += events.size();
  cells_->take(events);
  if (!events.empty()) {
    puncture_.take(events);
    facts_->show_puncture(text_of(puncture_.text()));
  }
  for (const Event& event : events) {
    if (event.kind == event_kind::kHint)
      notify(words("Hint: ") + text_of(say_event_detail(event.kind, event.detail)), false);
  }
  if (hint_until_s_ > 0.0 && now_s() > hint_until_s_) {
    hint_until_s_ = 0.0;
    feed_.set_hints({});
  }
  return events;
}

void GuideWindow::give_hint(const PersonHint& hint) {
  control_->give_hint(hint);
  feed_.set_hints({hint_mark(hint)});
  hint_until_s_ = now_s() + kHintMark_s;
  feed_panel_->view().render();
}

void GuideWindow::show_status() {
  const LiveStatus status = run_->status();
  if (options_.repeat) control_->repeat_when_ended(status, now_s());
  const StatusTexts texts = status_.update(status, scenes_.measured(), run_->paused(), drawn_count_, now_s());
  status_line_->show_texts(texts);
  if (now_s() >= notice_until_s_ || status.fault) status_line_->show_notice(texts.notice);
  if (status.fault && status.fault != shown_fault_) warn(text_of(say_message(*status.fault)));
  shown_fault_ = status.fault;
  display_->follow();
  if (hand_) hand_->show_status();
  top_bar_->show_state(status.recording, run_->paused());
}

// What must not be overlooked: large, and until a person has closed it.
void GuideWindow::warn(const QString& text) {
  problem_->say_text(text);
}

void GuideWindow::notify(const QString& text, bool problem) {
  status_line_->show_notice({text.toStdString(), problem ? current_theme().record : current_theme().accent});
  notice_until_s_ = now_s() + (problem ? kProblem_s : kNotice_s);
}

}  // namespace pellucida
