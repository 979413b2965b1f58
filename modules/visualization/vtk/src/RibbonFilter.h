#pragma once
#include <vtkPolyDataAlgorithm.h>

#include <string>
#include <vector>

#include "pellucida/visualization/Palette.h"

namespace pellucida {

/// Turns polylines in the image plane into flat ribbons with soft edges, so that lines of any width are smooth without
/// smoothing (and so altering) the image under them.
/// Input port 0: vtkPolyData with lines; a line that ends in its first point is closed. z is kept.
/// Output port 0: vtkPolyData of quads with
///   | array | type  | comp. | what                                          |
///   | color | uchar | 4     | red, green, blue, opacity; 0 at the outer rim |
/// Parameters: width and softness of the rim, um; the colour, by an integer cell array where one is named (a value
/// beyond the list takes the last colour), else the first colour; opacity. Lines of fewer than two points are left out.
/// Cost is linear in the points.
class RibbonFilter : public vtkPolyDataAlgorithm {
 public:
  static RibbonFilter* New();
  vtkTypeMacro(RibbonFilter, vtkPolyDataAlgorithm);
  RibbonFilter(const RibbonFilter&) = delete;
  void operator=(const RibbonFilter&) = delete;

  vtkSetClampMacro(WidthUm, double, 1e-6, 1e6);
  vtkSetClampMacro(RimUm, double, 1e-6, 1e6);
  vtkSetClampMacro(Opacity, double, 0.0, 1.0);
  /// `array`: name of the cell array that chooses among `colors`; empty for the first colour throughout.
  void SetColors(std::vector<Color> colors, std::string array = {});

 protected:
  RibbonFilter() = default;
  ~RibbonFilter() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  double WidthUm = 2.0;
  double RimUm = 1.0;
  double Opacity = 1.0;
  std::vector<Color> colors_{palette::kText};
  std::string array_;
};

}  // namespace pellucida
