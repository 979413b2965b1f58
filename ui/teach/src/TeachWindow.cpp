#include "TeachWindow.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "CellPage.h"
#include "ReadoutPage.h"
#include "SnakePage.h"
#include "Theme.h"
#include "Words.h"
#include "widgets/ButtonKey.h"
#include "widgets/Icons.h"
#include "widgets/LessonPanel.h"
#include "widgets/Panel.h"
#include "widgets/TitleBar.h"

namespace pellucida {
namespace {

constexpr int kTeachTick_ms = 33;
constexpr double kLargeLetters = 1.35;
constexpr double kKeyStep_um = 1.0;
constexpr int kSideWidth_px = 330;

struct PageName {
  const char* name;
  const char* tip;
  Qt::Key key;
};
// In the order of LessonPage.
constexpr PageName kPages[] = {
    {PELLUCIDA_WORDS("Cell"), PELLUCIDA_WORDS("A simulated cell to poke"), Qt::Key_F2},
    {PELLUCIDA_WORDS("Snake"), PELLUCIDA_WORDS("An active contour on a picture, step by step"), Qt::Key_F3},
    {PELLUCIDA_WORDS("Two read-outs"), PELLUCIDA_WORDS("The force read from a contour in two ways"), Qt::Key_F4}};

}  // namespace

LessonChoice choose_lessons(const std::string& name) {
  // The folder of the language's own.
  LessonChoice choice{all_lessons(say("lessons")), 0};
  if (name.empty()) return choice;
  const Lesson wanted = load_lesson(name);
  const auto same = std::find_if(choice.lessons.begin(), choice.lessons.end(),
                                 [&](const Lesson& lesson) { return lesson.name == name; });
  choice.first = static_cast<int>(same - choice.lessons.begin());
  if (same == choice.lessons.end()) choice.lessons.push_back(wanted);
  return choice;
}

TeachWindow::TeachWindow(LessonChoice lessons, TeachOptions options)
    : options_(std::move(options)),
      cell_(std::make_unique<CellPage>(lessons.lessons.at(static_cast<std::size_t>(lessons.first)).setting)),
      snake_(std::make_unique<SnakePage>()),
      readouts_(std::make_unique<ReadoutPage>()),
      pages_{cell_.get(), snake_.get(), readouts_.get()} {
  const int first = lessons.first;
  build(lessons);
  apply_look();
  lesson_panel_->open(first);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  timer_.start(0);
  screenshot_ = std::make_unique<TimedScreenshot>(*this, options_, [this] { page().show_newest(); });
}

TeachWindow::~TeachWindow() {
  timer_.stop();
  // The widgets show the pages' views: they go first.
  delete takeCentralWidget();
}

void TeachWindow::build(LessonChoice& lessons) {
  setWindowTitle(words("Pellucida, teach"));
  setWindowIcon(make_icon(Pictogram::kProgram));
  resize(options_.width_px, options_.height_px);
  setMinimumSize(1000, 640);

  auto* central = new QWidget(this);
  auto* column = new QVBoxLayout(central);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(build_top_bar());
  column->addWidget(figures_ = new QStackedWidget);
  figures_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  column->addSpacing(4);

  lesson_panel_ = new LessonPanel(
      std::move(lessons.lessons), [this](const Lesson& lesson) { begin(lesson); }, nullptr);
  auto* all = new QSplitter(Qt::Horizontal);
  all->setHandleWidth(4);
  all->setChildrenCollapsible(false);
  all->addWidget(new pellucida::Panel(words("Lessons"), lesson_panel_, nullptr));
  all->addWidget(build_stage());
  all->addWidget(side_ = new QStackedWidget);
  side_->setObjectName("sideStack");
  for (TeachPage* page : pages_) {
    figures_->addWidget(page->make_figures());
    stage_->addWidget(page->make_stage());
    side_->addWidget(page->make_side());
  }
  all->setStretchFactor(1, 1);
  const int lesson_px = std::min(kSideWidth_px, options_.width_px / 4);
  const int side_px = std::min(kSideWidth_px + 30, 3 * options_.width_px / 10);
  all->setSizes({lesson_px, options_.width_px - lesson_px - side_px, side_px});
  column->addWidget(all, 1);
  setCentralWidget(central);
  add_keys();
}

QWidget* TeachWindow::build_top_bar() {
  auto* bar = new TitleBar(nullptr);
  bar->add_start_button();
  bar->add_button(words("Start again"), Qt::Key_Home, words("From the lesson's beginning"),
                  [this] { page().restart(); })
      ->setObjectName("restart");
  withdraw_ =
      bar->add_button(words("Withdraw"), Qt::Key_W, words("The needle out of the cell"), [this] { cell_->withdraw(); });
  const auto add_look = [&](const QString& text, Qt::Key key, const QString& tip, bool& option) {
    auto* button = bar->add_button(text, key, tip, [this, &option] {
      option = !option;
      apply_look();
    });
    button->setCheckable(true);
    button->setChecked(option);
  };
  add_look(words("Large letters"), Qt::Key_T, words("For the last row"), options_.large_letters);
  bar->add_button(words("Full screen"), Qt::Key_F11, words("All of the screen, and back"),
                  [this] { isFullScreen() ? showNormal() : showFullScreen(); });
  bar->add_look_menu(Qt::Key_L);
  bar->add_name(words("Teach"), words("Lessons about cells, contours and forces"), true);
  return bar;
}

// The pages as tabs above what they show; their figures and controls follow.
QWidget* TeachWindow::build_stage() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  page_choice_ = new QTabBar;
  page_choice_->setObjectName("pages");
  page_choice_->setAccessibleName(words("What is shown"));
  page_choice_->setDrawBase(false);
  page_choice_->setExpanding(false);
  page_choice_->setFocusPolicy(Qt::TabFocus);
  for (const PageName& page : kPages) {
    page_choice_->setTabToolTip(page_choice_->addTab(words(page.name)), tip_with_key(words(page.tip), page.key));
  }
  connect(page_choice_, &QTabBar::currentChanged, this,
          [this](int index) { show_page(static_cast<LessonPage>(index)); });
  column->addWidget(page_choice_);
  column->addWidget(stage_ = new QStackedWidget, 1);
  return content;
}

void TeachWindow::add_keys() {
  const auto key = [this](const QKeySequence& keys, const QString& meaning, std::function<void()> act) {
    add_window_key(*this, keys, meaning, std::move(act));
  };
  key(QKeySequence::Quit, words("Close the window"), [this] { close(); });
  key(Qt::Key_PageDown, words("Next lesson"), [this] { lesson_panel_->open(lesson_panel_->current() + 1); });
  key(Qt::Key_PageUp, words("Lesson before"), [this] { lesson_panel_->open(lesson_panel_->current() - 1); });
  for (int k = 0; k < static_cast<int>(std::size(kPages)); ++k) {
    key(kPages[k].key, words(kPages[k].tip), [this, k] { page_choice_->setCurrentIndex(k); });
  }
  key(Qt::Key_V, words("Back to the first point of view"), [this] { page().reset_view(); });
  key(QKeySequence("Shift+Left"), words("Needle or circle to the left by 1 µm"),
      [this] { page().nudge(-kKeyStep_um, 0.0); });
  key(QKeySequence("Shift+Right"), words("Needle or circle to the right by 1 µm"),
      [this] { page().nudge(kKeyStep_um, 0.0); });
  key(QKeySequence("Shift+Up"), words("Needle or circle up by 1 µm"), [this] { page().nudge(0.0, kKeyStep_um); });
  key(QKeySequence("Shift+Down"), words("Needle or circle down by 1 µm"), [this] { page().nudge(0.0, -kKeyStep_um); });
}

void TeachWindow::apply_look() {
  const double letters = options_.large_letters ? kLargeLetters : 1.0;
  apply_theme(*qApp, current_theme(), letters);
  for (TeachPage* page : pages_) page->set_type_scale(letters);
}

void TeachWindow::begin(const Lesson& lesson) {
  const auto page = lesson_page(lesson.page);
  pages_[static_cast<std::size_t>(page)]->begin(lesson);
  show_page(page);
}

void TeachWindow::show_page(LessonPage page) {
  shown_ = page;
  const int index = static_cast<int>(page);
  page_choice_->setCurrentIndex(index);
  figures_->setCurrentIndex(index);
  stage_->setCurrentIndex(index);
  side_->setCurrentIndex(index);
  withdraw_->setVisible(page == LessonPage::kCell);
  for (std::size_t k = 0; k < pages_.size(); ++k) pages_[k]->set_shown(pages_[k] == &this->page());
}

void TeachWindow::tick() {
  QElapsedTimer spent;
  spent.start();
  page().tick();
  // A slow renderer must leave time for the mouse and the other threads.
  const int spent_ms = static_cast<int>(spent.elapsed());
  timer_.start(std::max(kTeachTick_ms - spent_ms, spent_ms / 3));
}

}  // namespace pellucida
