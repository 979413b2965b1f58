#pragma once
#include <QSplitter>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

#include "pellucida/charts_vtk/ForceChart.h"
#include "pellucida/core/Measurement.h"

namespace pellucida {

class ViewWidget;

/// Force over indentation and force over time, side by side. Each is drawn at most ten times a second, one after the
/// other in events of their own, and only when it has changed: they take most of a software renderer's time.
class ForceCharts : public QSplitter {
 public:
  explicit ForceCharts(QWidget* parent);
  ~ForceCharts() override;

  /// They are drawn soon. `true_force_uN`: of a frame, where somebody knows it; empty for nobody.
  void append(const std::vector<Measurement>& rows,
              const std::function<std::optional<double>(long frame)>& true_force_uN = {});
  /// The true force as a curve in both.
  void show_truth(bool shown);
  /// Draws both now where they have changed.
  void render();
  /// In a low window they may be lower than a view usually is.
  void set_low(bool low);

 private:
  ForceChart force_indentation_{ForceChartKind::kForceIndentation};
  ForceChart force_time_{ForceChartKind::kForceTime};
  void render_next();
  void draw_soon();

  ViewWidget* force_indentation_widget_;
  ViewWidget* force_time_widget_;
  QTimer timer_;
  bool time_is_next_ = true;
};

}  // namespace pellucida
