#include "StartWindow.h"

#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "Words.h"
#include "widgets/ButtonKey.h"
#include "widgets/CameraCard.h"
#include "widgets/LessonCard.h"
#include "widgets/RecentStrip.h"
#include "widgets/RecordingCard.h"
#include "widgets/TitleBar.h"
#include "widgets/VirtualCard.h"

namespace pellucida {
namespace {

constexpr int kTallestCard_px = 570;

std::filesystem::path ask_with_dialog(QWidget& window, bool folder) {
  const QString answer = folder ? QFileDialog::getExistingDirectory(&window, words("Open a folder"), QDir::homePath())
                                : QFileDialog::getOpenFileName(&window, words("Open a recording"), QDir::homePath());
  return answer.toStdString();
}

std::filesystem::path sessions_of(const StartOptions& options) {
  if (!options.sessions_folder.empty()) return options.sessions_folder;
  return QDir::home().filePath("Pellucida").toStdString();
}

}  // namespace

StartWindow::StartWindow(StartOptions options, AskForPath ask)
    : options_(std::move(options)), memory_(options_.settings_file) {
  const StartForm form = memory_.form();
  build(form, std::move(ask));
  make_current(form.card);
  card(form.card).setFocus(Qt::TabFocusReason);
  card(form.card).show_problem(in_words_of_page(say_message(options_.problem)));
  if (!options_.recording.empty()) recording_->take(options_.recording);
  screenshot_ = std::make_unique<TimedScreenshot>(*this, options_, [] {});
}

StartWindow::~StartWindow() {
  // The cards' threads report to them: they go before the rest.
  disconnect(qApp, nullptr, this, nullptr);
  delete takeCentralWidget();
}

void StartWindow::build(const StartForm& form, AskForPath ask) {
  setWindowTitle(words("Pellucida - Start"));
  setWindowIcon(make_icon(Pictogram::kProgram));
  const QSize remembered = options_.remembered_size ? memory_.size() : QSize();
  resize(remembered.isValid() ? remembered : QSize(options_.width_px, options_.height_px));
  setMinimumSize(1000, 640);
  setAcceptDrops(true);

  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* bar = new TitleBar(page);
  bar->add_look_menu();
  bar->add_name(words("1 to 4 choose a card, Enter starts it; or drop a file or a folder here"), {});
  column->addWidget(bar);
  auto* content = new QVBoxLayout;
  content->setContentsMargins(16, 14, 16, 12);
  content->setSpacing(12);
  if (!ask) ask = [this](bool folder) { return ask_with_dialog(*this, folder); };
  content->addWidget(build_cards(form, std::move(ask)), 1000);
  content->addWidget(new RecentStrip(sessions_of(options_),
                                     [this](const std::filesystem::path& session) { choose(review_of(session)); }));
  content->addStretch(1);
  column->addLayout(content, 1);
  setCentralWidget(page);
  add_keys();
}

QWidget* StartWindow::build_cards(const StartForm& form, AskForPath ask) {
  const auto starts = [this](StartCardId id) { return [this, id] { start(id); }; };
  recording_ = new RecordingCard(form, {starts(StartCardId::kRecording), std::move(ask),
                                        [this](const std::filesystem::path& session) { choose(review_of(session)); }});
  cards_ = {new VirtualCard(form, starts(StartCardId::kVirtual)), recording_,
            new CameraCard(form, options_.cameras_listing, starts(StartCardId::kCamera)),
            new LessonCard(form, starts(StartCardId::kLesson))};
  auto* row_widget = new QWidget;
  row_widget->setMaximumHeight(kTallestCard_px);
  auto* row = new QHBoxLayout(row_widget);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(12);
  for (StartCard* one : cards_) {
    one->setMinimumWidth(180);
    row->addWidget(one, 1);
  }
  // Wherever the focus goes, its card is the one that Enter starts.
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    for (StartCard* one : cards_) {
      if (now && (now == one || one->isAncestorOf(now))) make_current(one->id());
    }
  });
  return row_widget;
}

void StartWindow::add_keys() {
  const auto key = [this](const QKeySequence& keys, const QString& meaning, std::function<void()> act) {
    add_window_key(*this, keys, meaning, std::move(act), false);
  };
  key(QKeySequence::Quit, words("Close the window"), [this] { close(); });
  key(Qt::Key_Return, words("Start the chosen card, or press the button that has the focus"),
      [this] { press_enter(); });
  key(Qt::Key_Enter, words("The same, on the number pad"), [this] { press_enter(); });
  for (int k = 0; k < kStartCardCount; ++k) {
    key(Qt::Key_1 + k, words("Choose card %1").arg(k + 1),
        [this, k] { card(static_cast<StartCardId>(k)).setFocus(Qt::TabFocusReason); });
  }
}

// A button of its own, other than a card's start, is pressed; anything else starts the card.
void StartWindow::press_enter() {
  if (auto* button = qobject_cast<QAbstractButton*>(focusWidget()); button && !button->isCheckable()) {
    button->click();
  } else {
    start(current_);
  }
}

void StartWindow::make_current(StartCardId id) {
  current_ = id;
  for (StartCard* one : cards_) one->show_current(one->id() == id);
}

StartForm StartWindow::form() const {
  StartForm form;
  form.card = current_;
  for (const StartCard* one : cards_) one->write(form);
  return form;
}

void StartWindow::start(StartCardId id) {
  make_current(id);
  card(id).show_problem(std::string());
  card(id).clear_problems();
  auto decision = decide(form(), recording_->judged());
  if (auto* choice = std::get_if<StartChoice>(&decision)) {
    choose(std::move(*choice));
    return;
  }
  const auto& problem = std::get<StartProblem>(decision);
  if (!card(id).show_problem(problem)) card(id).show_problem(problem.text);
}

void StartWindow::choose(StartChoice choice) {
  choice_ = std::move(choice);
  close();
}

void StartWindow::closeEvent(QCloseEvent* event) {
  // A picture of the page is nobody's choice.
  if (options_.screenshot.empty()) memory_.keep(form(), size());
  QMainWindow::closeEvent(event);
}

void StartWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  align_cards();
}

void StartWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  align_cards();
}

void StartWindow::align_cards() {
  if (!centralWidget()) return;
  centralWidget()->layout()->activate();
  int height_px = 0;
  for (const StartCard* one : cards_) height_px = std::max(height_px, one->head_height_px());
  for (StartCard* one : cards_) one->set_head_height(height_px);
}

void StartWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void StartWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  const auto urls = event->mimeData()->urls();
  make_current(StartCardId::kRecording);
  if (urls.size() != 1 || !urls.front().isLocalFile()) {
    recording_->show_problem({StartField::kPath, words("Drop one file or one folder of this computer.")});
    return;
  }
  recording_->take(urls.front().toLocalFile().toStdString());
  recording_->setFocus(Qt::OtherFocusReason);
}

}  // namespace pellucida
