#pragma once
#include <QMainWindow>
#include <QTimer>
#include <array>
#include <memory>
#include <vector>

#include "TimedScreenshot.h"
#include "pellucida/teach/Teach.h"
#include "pellucida/teaching/Lesson.h"

class QPushButton;
class QStackedWidget;
class QTabBar;

namespace pellucida {

class CellPage;
class LessonPanel;
class ReadoutPage;
class SnakePage;
class TeachPage;

/// The lessons of a window, and which of them is first.
struct LessonChoice {
  std::vector<Lesson> lessons;
  int first = 0;
};
/// All shipped lessons, opened at the one named (empty: the first); one from a file comes after them. Throws as
/// `load_lesson`.
LessonChoice choose_lessons(const std::string& name);

/// The window in Teach mode: lessons on the left, what the open one is about in the middle (a page: the poked cell, a
/// snake, a contour read in two ways), the page's controls on the right. One timer drives the page that is shown.
class TeachWindow : public QMainWindow {
 public:
  TeachWindow(LessonChoice lessons, TeachOptions options);
  ~TeachWindow() override;

  const TimedScreenshot& screenshot() const noexcept { return *screenshot_; }
  CellPage& cell() noexcept { return *cell_; }
  SnakePage& snake() noexcept { return *snake_; }
  ReadoutPage& readouts() noexcept { return *readouts_; }
  LessonPanel& lessons() noexcept { return *lesson_panel_; }

 private:
  void build(LessonChoice& lessons);
  QWidget* build_top_bar();
  QWidget* build_stage();
  void add_keys();

  void tick();
  void begin(const Lesson& lesson);
  void show_page(LessonPage page);
  TeachPage& page() { return *pages_[static_cast<std::size_t>(shown_)]; }
  void apply_look();

  TeachOptions options_;
  std::unique_ptr<CellPage> cell_;
  std::unique_ptr<SnakePage> snake_;
  std::unique_ptr<ReadoutPage> readouts_;
  std::array<TeachPage*, 3> pages_{};  // by LessonPage
  LessonPage shown_ = LessonPage::kCell;

  LessonPanel* lesson_panel_ = nullptr;
  QTabBar* page_choice_ = nullptr;
  QStackedWidget* figures_ = nullptr;
  QStackedWidget* stage_ = nullptr;
  QStackedWidget* side_ = nullptr;
  QPushButton* withdraw_ = nullptr;
  QTimer timer_;
  std::unique_ptr<TimedScreenshot> screenshot_;
};

}  // namespace pellucida
