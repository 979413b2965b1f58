#pragma once
#include <functional>
#include <memory>

#include "pellucida/charts_vtk/CurveChart.h"
#include "widgets/Panel.h"

namespace pellucida {

class ViewWidget;

/// A chart with a head line. Where the x axis is the session's time, press or drag in it seeks.
class CurvePanel : public Panel {
 public:
  /// `seek`: called with a value of the x axis; empty: the mouse does nothing.
  CurvePanel(const QString& title, std::function<void(double)> seek, QWidget* parent);
  ~CurvePanel() override;

  CurveChart& chart() noexcept { return *chart_; }
  const CurveChart& chart() const noexcept { return *chart_; }
  ViewWidget& view() noexcept { return *view_; }
  void set_seek(std::function<void(double)> seek);
  void render();

 protected:
  bool eventFilter(QObject* target, QEvent* event) override;

 private:
  CurvePanel(std::unique_ptr<CurveChart> chart, const QString& title, QWidget* parent);
  CurvePanel(ViewWidget* view, const QString& title, QWidget* parent);

  std::unique_ptr<CurveChart> chart_;
  ViewWidget* view_;
  std::function<void(double)> seek_;
};

}  // namespace pellucida
