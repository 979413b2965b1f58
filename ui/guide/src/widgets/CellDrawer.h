#pragma once
#include <QFrame>
#include <functional>
#include <span>
#include <vector>

#include "presenters/CellLog.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace pellucida {

/// The cells of this run beside the views, with their outcome; and where recordings go.
class CellDrawer : public QFrame {
 public:
  struct Actions {
    std::function<void()> save;           ///< the list as a table
    std::function<void()> choose_folder;  ///< for recordings
    std::function<void()> close;
  };

  CellDrawer(Actions actions, QWidget* parent);

  /// The newest last, and in view.
  void show_cells(std::span<const CellRow> cells);
  void show_folder(const QString& folder);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QPushButton* add_button(const QString& text, const QString& tip, std::function<void()> action);

  QTreeWidget* list_;
  QPushButton* save_;
  QLabel* folder_;
  QString folder_text_;
  std::vector<CellRow> shown_;
};

}  // namespace pellucida
