#pragma once
#include <QWidget>
#include <filesystem>
#include <functional>

#include "BackgroundTask.h"
#include "FileChoice.h"
#include "presenters/CellTable.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace pellucida {

class TaskLine;

/// The cells of several sessions in one table, in a window of its own: a row a cell, sorted by any column; the groups
/// compared by the column chosen. Sessions are read on a thread of their own.
class CellsWindow : public QWidget {
 public:
  /// Opens a session at a time, s, in the window in Review mode.
  using Open = std::function<void(const std::filesystem::path& session, double time_s)>;

  CellsWindow(FileChoice choice, Open open, QWidget* parent);

  /// Adds the cells of a session, or of all sessions below a folder; one that can't be read is named, and left out.
  void add(const std::filesystem::path& folder);
  const CellTable& cells() const noexcept { return cells_; }
  bool reading() const noexcept { return reading_.running(); }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  struct Read;
  QPushButton* add_button(const char* name, const QString& text, const QString& tip, std::function<void()> act);
  void read_next();
  void fill();
  void fill_groups();
  void take_out();
  void open_row();
  void save();
  std::size_t row_of(int shown) const;

  FileChoice choice_;
  Open open_;
  CellTable cells_;
  std::vector<std::filesystem::path> waiting_;
  std::filesystem::path last_;
  QTableWidget* table_ = nullptr;
  QTableWidget* groups_ = nullptr;
  QLabel* group_title_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* save_ = nullptr;
  TaskLine* line_ = nullptr;
  std::size_t column_ = CellTable::kPeakForce;  // the groups are compared by it
  BackgroundTask reading_;
};

}  // namespace pellucida
