#pragma once
#include <QWidget>
#include <functional>
#include <vector>

#include "pellucida/teaching/Lesson.h"

class QLabel;
class QListWidget;
class QScrollArea;
class QVBoxLayout;

namespace pellucida {

/// The lessons: their list above, the page of one below, with its question.
class LessonPanel : public QWidget {
 public:
  /// `opened` is called with each lesson that is opened, or set up again.
  LessonPanel(std::vector<Lesson> lessons, std::function<void(const Lesson&)> opened, QWidget* parent);

  /// Opens the lesson of that place in the list; nothing beyond its ends.
  void open(int index);
  int current() const noexcept { return current_; }
  int count() const noexcept { return static_cast<int>(lessons_.size()); }
  /// Whether the lesson's question was answered rightly.
  bool is_done(int index) const { return done_[static_cast<std::size_t>(index)]; }

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void fit_list();
  void build_page(const Lesson& lesson);
  QLabel* add_text(const QString& html, const char* object_name);
  void add_list(const QString& head, const std::vector<std::string>& points, bool numbered);
  void answer(int choice);
  void show_titles();

  std::vector<Lesson> lessons_;
  std::vector<bool> done_;
  std::function<void(const Lesson&)> opened_;
  int current_ = -1;
  QListWidget* list_;
  QScrollArea* scroll_;
  QVBoxLayout* page_ = nullptr;  // of the lesson that is open
  QLabel* verdict_ = nullptr;
};

}  // namespace pellucida
