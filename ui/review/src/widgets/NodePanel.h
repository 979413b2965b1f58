#pragma once
#include <vtkSmartPointer.h>

#include <QWidget>
#include <functional>
#include <vector>

#include "presenters/NodeHistory.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class vtkPolyData;

namespace pellucida {

class CurvePanel;

/// One node of the membrane: what this frame's surface says of it, and one of its arrays drawn over the session's time
/// or along its meridian in this frame.
class NodePanel : public QWidget {
 public:
  struct Actions {
    std::function<void(double)> seek;  ///< a time in the chart over time
    std::function<void()> cancel;      ///< ends the reading of the history
    std::function<void()> close;       ///< no node any more
  };
  NodePanel(Actions actions, QWidget* parent);

  /// Another node: its history is still to come.
  void set_node(long number);
  /// The surface shown now (may be null) and its time.
  void show_frame(vtkPolyData* surface, double time_s);
  void show_history(NodeHistory history);
  /// How many steps were read of how many; 0 of 0: nothing is being read.
  void show_progress(std::size_t done, std::size_t all);
  /// In place of the chart: why there is none.
  void show_problem(const QString& text);

  void choose_array(NodeArray array);
  void choose_meridian(bool on);

  CurvePanel& curve() noexcept { return *curve_; }
  void render();

 private:
  QWidget* build_facts();
  void build_controls();
  void show_facts(const std::vector<NodeFact>& facts);
  void fill_chart();
  void place_cursor();

  Actions actions_;
  long number_ = 0;
  NodeHistory history_;
  double time_s_ = 0.0;
  vtkSmartPointer<vtkPolyData> surface_;
  QGridLayout* facts_ = nullptr;
  CurvePanel* curve_ = nullptr;
  QComboBox* array_ = nullptr;
  QComboBox* axis_ = nullptr;
  QWidget* progress_row_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QString problem_;
};

}  // namespace pellucida
