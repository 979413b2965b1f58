#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <functional>
#include <span>

#include "BackgroundTask.h"
#include "presenters/CellLog.h"

namespace pellucida {

class CellDrawer;
class RecordStrip;
class RunControl;
struct Scene;

/// The cells of the run: their names, the list beside the views, its table.
class CellControl : public QObject {
 public:
  /// What is said to the person: the text, and whether it is a problem.
  using Notify = std::function<void(const QString&, bool)>;

  /// `run` and `window` must outlive the control; drawer and strip belong to `window`. `close_drawer`: at the person's
  /// wish.
  CellControl(RunControl& run, const std::string& profile, QWidget& window, std::function<void()> close_drawer,
              Notify notify);

  CellDrawer* drawer() const noexcept { return drawer_; }
  RecordStrip* strip() const noexcept { return strip_; }

  /// The scene shown and the rows up to it; the run's next events.
  void take(const Scene& scene, std::span<const Measurement> rows);
  void take(std::span<const Event> events);

  /// A recording has begun: it is told the cell's name, and one is offered.
  void begin_recording();
  void begin_name();
  void begin_note();

 private:
  void evaluate();
  void show_cells();
  void save();
  void choose_folder();

  RunControl& run_;
  QWidget& window_;
  Notify notify_;
  CellLog log_;
  long run_index_ = 0;
  bool is_stale_ = false;
  QElapsedTimer evaluated_;
  BackgroundTask task_;
  CellDrawer* drawer_;
  RecordStrip* strip_;
};

}  // namespace pellucida
