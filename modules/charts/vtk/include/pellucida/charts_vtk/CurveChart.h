#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/charts/Curve.h"
#include "pellucida/visualization_vtk/View.h"

namespace pellucida {

/// An upright line at a place of the x axis, named at its upper end where there is room.
struct CurveMark {
  double x = 0.0;
  std::string name;
  Color color;
};

/// How a named curve is drawn.
enum class CurveRole {
  kBack,            ///< the same as the curve, on its way back: dashed, in its colour
  kReference,       ///< what a model or a table says: dashed, in a colour of its own
  kFaintReference,  ///< likewise, in grey
};

/// A further curve, without a band.
struct NamedCurve {
  std::string name;
  Curve curve;
  CurveRole role = CurveRole::kReference;
};

/// What a `CurveChart` shows.
struct CurveChartData {
  std::string x_title;  ///< with its unit
  std::string y_title;
  Curve faint;                         ///< behind the curve, in grey, without a band
  Curve curve;                         ///< with its band
  Curve inner;                         ///< the same points with a narrower band, drawn over it; empty: none
  Curve other;                         ///< what it is held against, in another colour, with its band
  std::string curve_name, other_name;  ///< where there are two curves, each is named
  std::vector<NamedCurve> named;       ///< below the curve; each is named, and so is the curve then
  std::string band_name;               ///< of the curve, in print; empty: the 95 % interval
  std::vector<CurveMark> marks;
  double x_begin = 0.0;  ///< ends of the x axis; equal: 0 and a round number above the data
  double x_end = 0.0;
  std::string empty_text;  ///< in place of the curves where both are empty
};

/// A finished curve of any length with its 95 % band and a narrower one in it, a grey one behind it, one to compare it
/// with, and a cursor: an
/// upright line at a place of the x axis, a dot on the curve. Long curves are thinned to what a screen can show; their
/// peaks remain.
class CurveChart : public View {
 public:
  static constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  /// Points a drawn curve has at most.
  static constexpr std::size_t kMostPoints = 4000;

  CurveChart();
  ~CurveChart() override;

  void follow_theme() override;

  void set_data(CurveChartData data);
  /// As it was given.
  const CurveChartData& data() const noexcept;
  /// `y` NaN: an upright line at `x`; `line` false: the dot alone. NaN for both: none.
  void set_cursor(double x, double y, bool line);
  double cursor_x() const noexcept { return cursor_x_; }
  double cursor_y() const noexcept { return cursor_y_; }

  /// The value of the x axis under a point `x_px` logical pixels from the left, held within the axis; nothing before
  /// the first rendering.
  std::optional<double> x_at(double x_px) const;

 protected:
  void prepare(double width_px, double height_px) override;
  void draw_hud(HudCanvas& hud, double width_px, double height_px) override;

 private:
  struct Plots;
  void fill();
  std::vector<const Curve*> curves() const;
  void set_ranges(double width_px, double height_px);
  void draw_marks(HudCanvas& hud) const;
  void draw_names(HudCanvas& hud) const;
  void draw_cursor(HudCanvas& hud) const;

  std::unique_ptr<Plots> plots_;
  bool changed_ = true;
  double styled_ratio_ = 0.0;
  double cursor_x_ = kNowhere;
  double cursor_y_ = kNowhere;
  bool cursor_line_ = true;
};

}  // namespace pellucida
