#include "MainWindow.h"

#include <vtkInteractorStyleTrackballCamera.h>

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QPixmap>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QStandardPaths>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "HandControl.h"
#include "pellucida/core/Error.h"
#include "pellucida/visualization_vtk/PanZoomStyle.h"
#include "presenters/SourcePresenter.h"
#include "widgets/ArrowMenu.h"
#include "widgets/HandBar.h"
#include "widgets/Icons.h"
#include "widgets/Panel.h"
#include "widgets/ReadoutBar.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr int kTick_ms = 33;
constexpr double kChartPeriod_s = 0.1;
constexpr double kStatusPeriod_s = 0.1;
constexpr double kRepeatPause_s = 2.0;
constexpr double kNotice_s = 6.0;
constexpr double kTimeWindow_s = 60.0;
constexpr int kChartSamples = 4;

QString text_of(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

QLabel* add_label(QLayout* row, const char* name, const QString& text = {}) {
  auto* label = new QLabel(text);
  label->setObjectName(name);
  row->addWidget(label);
  return label;
}

void show_phrase(QLabel* label, const Phrase& phrase) {
  label->setText(text_of(phrase.text));
  label->setStyleSheet("color: " + text_of(phrase.color.css()));
}

}  // namespace

MainWindow::MainWindow(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console, WindowOptions options)
    : run_(std::move(run)),
      console_(std::move(console)),
      options_(std::move(options)),
      recordings_(options_.session_folder, QDir::homePath().toStdString()) {
  source_->SetExchange(run_->scenes());
  force_time_.set_time_window_s(kTimeWindow_s);
  feed_.set_caption(source_caption(run_->source_info()));
  build();
  add_shortcuts();
  clock_.start();
  show_status();
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  timer_.start(0);
  run_->start();
  if (console_ && options_.hand >= 0) console_->choose(options_.hand);
  if (!options_.screenshot.empty()) {
    QTimer::singleShot(static_cast<int>(1000.0 * options_.screenshot_after_s), this,
                       [this] { finish_with_screenshot(); });
  }
}

MainWindow::~MainWindow() {
  timer_.stop();
  hand_.reset();
  console_.reset();
  run_->stop();
  // The widgets show the views: they go first.
  delete takeCentralWidget();
}

void MainWindow::build() {
  setWindowTitle(text_of(window_title(run_->source_info())));
  setWindowIcon(make_icon(Pictogram::kProgram));
  resize(options_.width_px, options_.height_px);
  setMinimumSize(1000, 640);

  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(build_top_bar());
  readouts_ = new ReadoutBar(page);
  column->addWidget(readouts_);
  QWidget* feed_panel = build_feed_panel();
  if (console_) {
    hand_ = std::make_unique<HandControl>(*console_, feed_, *feed_widget_, *this,
                                          [this](const QString& text, bool problem) { notify(text, problem); });
    column->addWidget(hand_->bar());
  }

  // Views above, charts below; every border can be dragged.
  auto* views = new QSplitter(Qt::Horizontal);
  views->setHandleWidth(4);
  views->addWidget(feed_panel);
  views->addWidget(build_membrane_panel());
  auto* all = new QSplitter(Qt::Vertical);
  all->setHandleWidth(4);
  all->setChildrenCollapsible(false);
  views->setChildrenCollapsible(false);
  QSplitter* charts = build_charts();
  all->addWidget(views);
  all->addWidget(charts);
  // The upright borders are aligned, and stay so.
  for (QSplitter* one : {views, charts}) {
    one->setStretchFactor(0, 1);
    one->setStretchFactor(1, 1);
    one->setSizes({10000, 10000});
  }
  connect(views, &QSplitter::splitterMoved, charts, [=] { charts->setSizes(views->sizes()); });
  connect(charts, &QSplitter::splitterMoved, views, [=] { views->setSizes(charts->sizes()); });
  all->setStretchFactor(0, 3);
  all->setStretchFactor(1, 1);
  all->setSizes({520, 250});
  column->addSpacing(4);
  column->addWidget(all, 1);
  column->addWidget(build_status_line());
  setCentralWidget(page);
}

QPushButton* MainWindow::add_top_button(QLayout* row, const QString& text, const QString& tip) {
  auto* button = new QPushButton;
  button->setText(text);
  button->setToolTip(tip);
  button->setFixedHeight(30);
  button->setFocusPolicy(Qt::TabFocus);
  row->addWidget(button);
  return button;
}

QWidget* MainWindow::build_top_bar() {
  auto* bar = new QWidget;
  bar->setObjectName("topBar");
  bar->setAttribute(Qt::WA_StyledBackground);
  bar->setFixedHeight(46);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(16, 0, 16, 0);
  row->setSpacing(8);
  auto* mark = new QLabel;
  mark->setPixmap(make_icon(Pictogram::kProgram).pixmap(22, 22));
  row->addWidget(mark);
  add_label(row, "brand", "Pellucida");
  row->addSpacing(18);

  record_ = add_top_button(row, "Record", "Write frames, shapes and forces to a session folder (R)");
  record_->setObjectName("record");
  record_->setCheckable(true);
  record_->setIcon(make_icon(Pictogram::kRecord));
  connect(record_, &QPushButton::clicked, this, [this] { toggle_recording(); });
  pause_ = add_top_button(row, "Pause", "Keep the newest frame on screen (Space)");
  pause_->setIcon(make_icon(Pictogram::kPause));
  connect(pause_, &QPushButton::clicked, this, [this] { toggle_pause(); });
  if (run_->can_restart()) {
    auto* restart = add_top_button(row, "Restart", "Start the source again from its first frame (Home)");
    restart->setIcon(make_icon(Pictogram::kRestart));
    connect(restart, &QPushButton::clicked, this, [this] { restart_source(); });
  }
  auto* note = add_top_button(row, "Note", "Add a remark to the session's events (N)");
  note->setIcon(make_icon(Pictogram::kNote));
  connect(note, &QPushButton::clicked, this, [this] { ask_for_note(); });
  auto* picture = add_top_button(row, "Screenshot", "Save the window as a picture (Ctrl+S)");
  picture->setIcon(make_icon(Pictogram::kCamera));
  connect(picture, &QPushButton::clicked, this, [this] { save_picture(); });

  row->addStretch(1);
  QLabel* source = add_label(row, "sourceName", text_of(source_label(run_->source_info())));
  source->setToolTip(text_of(run_->source_info().name));
  return bar;
}

QWidget* MainWindow::build_status_line() {
  auto* line = new QWidget;
  line->setObjectName("statusLine");
  line->setAttribute(Qt::WA_StyledBackground);
  line->setFixedHeight(30);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(16, 0, 16, 0);
  row->setSpacing(24);
  frame_age_ = add_label(row, "statusText");
  frame_rate_ = add_label(row, "statusText");
  lost_ = add_label(row, "statusText");
  // Room for the widest text, so that nothing jumps.
  QFont letters = frame_age_->font();
  letters.setPixelSize(12);
  const QFontMetrics width(letters);
  frame_age_->setMinimumWidth(width.horizontalAdvance("Frame age 0000 ms") + 6);
  frame_rate_->setMinimumWidth(width.horizontalAdvance("000.0 frames/s") + 6);
  lost_->setMinimumWidth(width.horizontalAdvance("00000 frames skipped") + 6);
  notice_ = add_label(row, "statusText");
  notice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addStretch(1);
  recording_ = add_label(row, "statusText");
  recording_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return line;
}

QWidget* MainWindow::build_feed_panel() {
  feed_widget_ = new ViewWidget(feed_, 0, nullptr);
  vtkNew<PanZoomStyle> style;
  feed_widget_->set_style(style);
  auto* panel = new Panel("Microscope", feed_widget_, nullptr);
  const auto toggle = [&](const char* text, const char* tip, const QKeySequence& key, auto change) {
    QToolButton* button = panel->add_toggle(text, tip, true);
    button->setShortcut(key);
    connect(button, &QToolButton::toggled, this, [this, change](bool on) {
      (feed_.*change)(on);
      feed_widget_->render();
    });
  };
  toggle("Contours", "Membranes found in the image (1)", Qt::Key_1, &FeedView::show_contours);
  toggle("Model", "Section through the mechanical model (2)", Qt::Key_2, &FeedView::show_model_section);
  toggle("Tools", "Needle and holding pipette (3)", Qt::Key_3, &FeedView::show_tools);
  QToolButton* whole = panel->add_toggle("Whole frame", "The whole image instead of the cell (W)", false);
  whole->setShortcut(Qt::Key_W);
  connect(whole, &QToolButton::toggled, this, [this](bool on) {
    feed_.set_framing(on ? FeedFraming::kFrame : FeedFraming::kCell);
    feed_widget_->render();
  });
  QToolButton* reset = panel->add_button("Reset", "Undo panning and zooming (F)");
  reset->setShortcut(Qt::Key_F);
  connect(reset, &QToolButton::clicked, this, [this] {
    feed_.reset_camera();
    feed_widget_->render();
  });
  return panel;
}

QWidget* MainWindow::build_membrane_panel() {
  membrane_widget_ = new ViewWidget(membranes_, 0, nullptr);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  membrane_widget_->set_style(style);
  auto* panel = new Panel("Forces in 3-D", membrane_widget_, nullptr);

  add_coloring_menu(panel);
  panel->add_control(new ArrowMenu(
      membranes_, [this] { membrane_widget_->render(); }, panel));
  QToolButton* tools = panel->add_toggle("Tools", "Needle and holding pipette (4)", true);
  tools->setShortcut(Qt::Key_4);
  connect(tools, &QToolButton::toggled, this, [this](bool on) {
    membranes_.show_tools(on);
    membrane_widget_->render();
  });
  QToolButton* reset = panel->add_button("Reset", "Back to the first point of view (Home)");
  reset->setShortcut(Qt::Key_Home);
  connect(reset, &QToolButton::clicked, this, [this] {
    membranes_.reset_camera();
    membrane_widget_->render();
  });
  return panel;
}

void MainWindow::add_coloring_menu(Panel* panel) {
  QToolButton* button = panel->add_button({}, "What the colour of the outer membrane shows");
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  auto* choice = new QActionGroup(menu);
  const std::pair<const char*, SurfaceColoring> entries[] = {{"Plain", SurfaceColoring::kPlain},
                                                             {"Tension", SurfaceColoring::kTension},
                                                             {"Displacement", SurfaceColoring::kDisplacement}};
  for (const auto& [name, coloring] : entries) {
    QAction* action = choice->addAction(menu->addAction(name));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, button, name = QString(name), kind = coloring] {
      button->setText(QString::fromUtf8("Surface: %1 \u25BE").arg(name.toLower()));
      membranes_.set_coloring(kind);
      membrane_widget_->render();
    });
  }
  button->setText(QString::fromUtf8("Surface: plain \u25BE"));
  choice->actions().first()->setChecked(true);
  button->setMenu(menu);
}

QSplitter* MainWindow::build_charts() {
  auto* charts = new QSplitter(Qt::Horizontal);
  charts->setHandleWidth(4);
  charts->setChildrenCollapsible(false);
  force_indentation_widget_ = new ViewWidget(force_indentation_, kChartSamples, nullptr);
  force_time_widget_ = new ViewWidget(force_time_, kChartSamples, nullptr);
  charts->addWidget(new Panel("Force over indentation", force_indentation_widget_, nullptr));
  charts->addWidget(new Panel("Force over time", force_time_widget_, nullptr));
  return charts;
}

void MainWindow::add_shortcuts() {
  const auto add = [this](const QKeySequence& key, auto action) {
    connect(new QShortcut(key, this), &QShortcut::activated, this, [this, action] { (this->*action)(); });
  };
  add(Qt::Key_R, &MainWindow::toggle_recording);
  add(Qt::Key_Space, &MainWindow::toggle_pause);
  add(Qt::Key_Home, &MainWindow::restart_source);
  add(Qt::Key_N, &MainWindow::ask_for_note);
  add(QKeySequence::Save, &MainWindow::save_picture);
  connect(new QShortcut(QKeySequence::Quit, this), &QShortcut::activated, this, [this] { close(); });
}

void MainWindow::tick() {
  QElapsedTimer spent;
  spent.start();
  const double now_s = 1e-3 * static_cast<double>(clock_.elapsed());
  const bool plan_changed = hand_ && hand_->tick();
  if (poll_scene()) {
    feed_.refresh();
    membranes_.refresh();
    feed_widget_->render();
    membrane_widget_->render();
  } else if (plan_changed) {
    feed_widget_->render();
  }
  poll_rows();
  if (rows_new_ && now_s - charts_shown_s_ >= kChartPeriod_s) {
    force_indentation_widget_->render();
    force_time_widget_->render();
    charts_shown_s_ = now_s;
    rows_new_ = false;
  }
  if (now_s - status_shown_s_ >= kStatusPeriod_s) {
    show_status();
    status_shown_s_ = now_s;
  }
  // A slow renderer must leave time for the mouse and the other threads.
  const int spent_ms = static_cast<int>(spent.elapsed());
  timer_.start(std::max(kTick_ms - spent_ms, spent_ms / 3));
}

// The newest measured scene; until there is one, the newest frame as it came.
bool MainWindow::poll_scene() {
  if (source_->Poll()) {
    scene_seen_ = true;
    return true;
  }
  if (scene_seen_) return false;
  const auto frame = run_->frames()->peek();
  if (!frame) return false;
  source_->SetScene(*frame);
  return true;
}

void MainWindow::poll_rows() {
  for (const Measurement& row : run_->measurements_since(row_count_)) {
    force_indentation_.append(row);
    force_time_.append(row);
    ++row_count_;
    rows_new_ = true;
  }
}

void MainWindow::show_status() {
  const LiveStatus status = run_->status();
  const double now_s = 1e-3 * static_cast<double>(clock_.elapsed());
  repeat_when_ended(status, now_s);
  std::optional<Measurement> row;
  if (scene_seen_) row = source_->GetScene().measurement;
  const StatusTexts texts = status_.update(status, row, run_->paused(), now_s);
  readouts_->show_texts(texts);
  show_phrase(frame_age_, texts.frame_age);
  show_phrase(frame_rate_, texts.frame_rate);
  show_phrase(lost_, texts.lost);
  show_phrase(recording_, texts.recording);
  if (hand_) hand_->show_status();
  if (now_s >= notice_until_s_ || status.fault) show_phrase(notice_, texts.notice);

  record_->setChecked(status.recording);
  record_->setText(status.recording ? "Stop" : "Record");
  record_->setIcon(make_icon(status.recording ? Pictogram::kStop : Pictogram::kRecord));
  pause_->setText(run_->paused() ? "Resume" : "Pause");
  pause_->setIcon(make_icon(run_->paused() ? Pictogram::kPlay : Pictogram::kPause));
}

// A source that repeats begins anew after its end has been seen for a moment.
void MainWindow::repeat_when_ended(const LiveStatus& status, double now_s) {
  if (!options_.repeat || !status.finished || run_->paused()) {
    ended_s_.reset();
    return;
  }
  if (!ended_s_) ended_s_ = now_s;
  if (now_s - *ended_s_ < kRepeatPause_s) return;
  ended_s_.reset();
  run_->restart();
}

void MainWindow::notify(const QString& text, bool problem) {
  show_phrase(notice_, {text.toStdString(), problem ? palette::kRecord : palette::kAccent});
  notice_until_s_ = 1e-3 * static_cast<double>(clock_.elapsed()) + kNotice_s;
}

void MainWindow::toggle_recording() {
  try {
    if (run_->status().recording) {
      run_->stop_recording();
    } else {
      run_->start_recording(recordings_.next_folder(RecordingPresenter::utc_stamp()));
    }
  } catch (const Error& error) {
    notify(error.what(), true);
  }
  show_status();
}

void MainWindow::toggle_pause() {
  run_->set_paused(!run_->paused());
  show_status();
}

void MainWindow::restart_source() {
  run_->set_paused(false);
  run_->restart();
  show_status();
}

void MainWindow::ask_for_note() {
  bool given = false;
  const QString text =
      QInputDialog::getText(this, "Note", "Remark for the session's events:", QLineEdit::Normal, {}, &given);
  if (!given || text.trimmed().isEmpty()) return;
  const bool written = run_->note(text.trimmed().toStdString());
  notify(written ? "Note written into the recording" : "Nothing is recording: the note goes into the next recording",
         false);
}

void MainWindow::save_picture() {
  const QString file = text_of(recordings_.picture_file(RecordingPresenter::utc_stamp()).string());
  QDir().mkpath(QFileInfo(file).path());
  const bool saved = grab().save(file, "PNG");
  notify((saved ? "Screenshot saved: " : "The screenshot can't be written: ") + file, !saved);
}

void MainWindow::finish_with_screenshot() {
  // What is on screen may lag behind by a tick: all parts once more, then the picture.
  poll_scene();
  poll_rows();
  feed_.refresh();
  membranes_.refresh();
  render_views();
  show_status();
  if (!grab().save(text_of(options_.screenshot), "PNG")) {
    screenshot_fault_ = std::make_exception_ptr(OutputError("can't write the screenshot " + options_.screenshot +
                                                            ": choose a folder that exists and may be written"));
  }
  close();
}

void MainWindow::render_views() {
  for (ViewWidget* widget : {feed_widget_, membrane_widget_, force_indentation_widget_, force_time_widget_})
    widget->render();
}

}  // namespace pellucida
