#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/charts/TraceHistory.h"
#include "pellucida/core/Measurement.h"
#include "pellucida/visualization/Palette.h"
#include "pellucida/visualization_vtk/View.h"

namespace pellucida {

enum class ForceChartKind {
  kForceIndentation,  ///< the present touch, the one before it behind in grey
  kForceTime,         ///< the last `time_window_s`, or all
};

/// A curve of the contact force in uN with its 95 % band and the present value marked; over indentation the band goes
/// along the way in alone, and the present value has its interval as a bar; over time also the moments of
/// contact, puncture and loss.
class ForceChart : public View {
 public:
  explicit ForceChart(ForceChartKind kind);
  ~ForceChart() override;

  /// `true_force_uN`: of a virtual cell; NaN where nobody knows it.
  void append(const Measurement& m, double true_force_uN = std::numeric_limits<double>::quiet_NaN());
  /// The true force as a curve in front of the others, named; not shown at first.
  void show_truth(bool shown);
  void clear();
  /// A curve behind the others on kForceIndentation, in place of the touch before; `name` is written beside it.
  void set_reference(std::string name, const std::vector<double>& depth_um, const std::vector<double>& force_uN);
  void follow_theme() override;
  /// True when the next rendering would show something else than the last one.
  bool is_stale() const noexcept { return changed_; }
  /// The newest point, as it is marked.
  std::optional<TracePoint> newest() const;
  /// Width of the time axis in s; 0 (the default) shows all. Of no effect on kForceIndentation.
  void set_time_window_s(double window_s);

 protected:
  void prepare(double width_px, double height_px) override;
  void draw_hud(HudCanvas& hud, double width_px, double height_px) override;

 private:
  struct Plots;
  const std::vector<TracePoint>& points() const;
  void style_axes(double ratio);
  void fill();
  void set_ranges();
  void draw_marks(HudCanvas& hud) const;
  void draw_truth_name(HudCanvas& hud, double width_px) const;
  void draw_interval(HudCanvas& hud, const TracePoint& point) const;

  ForceChartKind kind_;
  const std::vector<TracePoint>& behind() const;
  void draw_reference_name(HudCanvas& hud) const;

  TraceHistory history_;
  const ThemeColors* theme_ = &current_theme();
  std::string reference_name_;
  std::vector<TracePoint> reference_;
  std::unique_ptr<Plots> plots_;
  double time_window_s_ = 0.0;
  bool truth_shown_ = false, changed_ = true;
  double styled_ratio_ = 0.0;
};

}  // namespace pellucida
