#pragma once
#include <QSplitter>
#include <vector>

#include "pellucida/charts_vtk/ForceChart.h"
#include "pellucida/core/Measurement.h"

namespace pellucida {

class ViewWidget;

/// Force over indentation and force over time, side by side.
class ForceCharts : public QSplitter {
 public:
  explicit ForceCharts(QWidget* parent);
  ~ForceCharts() override;

  void append(const std::vector<Measurement>& rows);
  void render();
  /// In a low window they may be lower than a view usually is.
  void set_low(bool low);

 private:
  ForceChart force_indentation_{ForceChartKind::kForceIndentation};
  ForceChart force_time_{ForceChartKind::kForceTime};
  ViewWidget* force_indentation_widget_;
  ViewWidget* force_time_widget_;
};

}  // namespace pellucida
