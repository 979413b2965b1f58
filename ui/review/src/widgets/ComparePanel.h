#pragma once
#include <vtkNew.h>

#include <QWidget>
#include <functional>
#include <vector>

#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "presenters/SessionComparison.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QStackedWidget;

namespace pellucida {

class CurvePanel;
class Panel;
class ViewWidget;

/// Another session beside the one shown: its frame as image or in 3-D, the numbers of both, and the difference of their
/// forces as a chart.
class ComparePanel : public QWidget {
 public:
  struct Actions {
    std::function<void(Alignment)> align;
    std::function<void()> close;
    std::function<void()> save_chart;  ///< the difference, as a drawing
    std::function<void()> save_table;  ///< the same as CSV
  };
  ComparePanel(Actions actions, QWidget* parent);
  ~ComparePanel() override;

  /// Its name, and what is known of it.
  void set_session(const QString& name, const QString& facts);
  /// The other session's frame; an empty scene where it has none for this one.
  void show_scene(const Scene& scene);
  void show_rows(const std::vector<ComparisonRow>& rows);
  /// In place of the views, for instance while the session is read.
  void show_text(const QString& text);
  void choose_alignment(Alignment alignment);
  void choose_forces(bool in_3d);

  const StageSource& source() const { return *source_; }
  CurvePanel& curve() noexcept { return *curve_; }
  void render();

 private:
  QWidget* build_views();
  QWidget* build_table();
  void refresh_view();

  Actions actions_;
  vtkNew<StageSource> source_;
  FeedView feed_{source_};
  MembraneView membranes_{source_};
  Panel* head_ = nullptr;
  QStackedWidget* views_ = nullptr;
  ViewWidget* image_ = nullptr;
  ViewWidget* forces_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* text_ = nullptr;
  QComboBox* view_choice_ = nullptr;
  QComboBox* alignment_ = nullptr;
  QGridLayout* table_ = nullptr;
  CurvePanel* curve_ = nullptr;
};

}  // namespace pellucida
