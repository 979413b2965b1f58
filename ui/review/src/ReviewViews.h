#pragma once
#include <vtkNew.h>

#include <QPoint>
#include <QSplitter>
#include <functional>
#include <vector>

#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "presenters/Histogram.h"
#include "presenters/SessionComparison.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace pellucida {

class CurvePanel;
class FeedPanel;
class ModelReview;
class MembranePanel;

/// The views of a recorded session: image and 3-D membranes above, both charts of the whole session below, with a
/// cursor at the frame shown. A press in the time chart seeks, a click on the membrane picks a node.
class ReviewViews : public QSplitter {
 public:
  /// `seek`: a time, s. `pick`: a node's number.
  ReviewViews(std::function<void(double)> seek, std::function<void(long)> pick, QWidget* parent);
  ~ReviewViews() override;

  /// `session` must outlive its showing.
  void set_session(const RecordedSession& session);
  /// Shows a step; the charts are drawn by `draw_charts`.
  void show_step(const Scene& scene, std::size_t step);
  void draw_charts();
  /// Whether a chart has new data since it was drawn.
  bool charts_changed() const noexcept { return charts_changed_; }
  /// Lays another session's curves over the charts; null: none. `comparison` must outlive its showing.
  void compare(const SessionComparison* comparison, Alignment alignment);
  /// The model's curves in the force over indentation.
  ModelReview& model() noexcept { return *model_; }
  const ModelReview& model() const noexcept { return *model_; }
  void mark_node(std::optional<long> node);
  /// Where a person pointed, in the frame shown.
  void mark_hints(std::vector<HintMark> marks);
  FeedView& image() noexcept { return feed_; }

  const StageSource& source() const { return *source_; }
  /// What is counted in place of the force over indentation; nothing: that.
  std::optional<Quantity> histogram() const noexcept { return histogram_; }
  void show_histogram(std::optional<Quantity> quantity);
  Sample sample() const;
  FeedPanel& feed() noexcept { return *feed_panel_; }
  MembranePanel& membranes() noexcept { return *membrane_panel_; }
  CurvePanel& force_over_time() noexcept { return *time_; }
  CurvePanel& force_over_indentation() noexcept { return *touch_; }

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  void fill_time();
  void fill_touch(std::size_t step);
  void fill_histogram();
  void place_touch_cursor(const Measurement& row);
  void build_touch();
  void build(std::function<void(double)> seek);

  vtkNew<StageSource> source_;
  FeedView feed_{source_};
  MembraneView membranes_{source_};
  FeedPanel* feed_panel_ = nullptr;
  MembranePanel* membrane_panel_ = nullptr;
  CurvePanel* time_ = nullptr;
  CurvePanel* touch_ = nullptr;
  ModelReview* model_ = nullptr;
  QComboBox* shown_ = nullptr;
  QToolButton* model_button_ = nullptr;
  QLabel* facts_ = nullptr;
  std::optional<Quantity> histogram_;
  bool charts_changed_ = false;
  std::function<void(long)> pick_;
  const RecordedSession* session_ = nullptr;
  const SessionComparison* comparison_ = nullptr;
  Alignment alignment_ = Alignment::kTime;
  std::size_t step_ = 0;
  std::optional<std::size_t> touch_shown_;
  std::optional<QPoint> pressed_px_;
};

}  // namespace pellucida
