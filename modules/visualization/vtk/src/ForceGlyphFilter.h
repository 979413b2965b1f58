#pragma once
#include <vtkPolyDataAlgorithm.h>

#include <vector>

namespace pellucida {

/// Chooses the nodes of the outer membrane that get an arrow, spread evenly and the same from frame to frame.
/// Input port 0: vtkPolyData, the surface with `membrane` and `force_uN` (without forces the output is empty).
/// Output port 0: vtkPolyData, points only, with
///   | array            | type   | comp. | what                                                                |
///   | force_uN         | double | 3     | as in the input                                                     |
///   | magnitude_uN     | double | 1     | its length                                                          |
///   | arrow_length_um  | double | 1     | LongestArrowUm at FullScaleUN, at most 1.5 of it                    |
///   | color_uN         | double | 1     | its length; NaN where it can't be told from zero: below 1.96 sigma  |
///   | bar_um           | double | 2     | lengths at the ends of its 95 % interval; equal: no interval known  |
///   | arrow_kind       | int    | 1     | 0 starts at the node, 1 (the force pushes inward) ends at it        |
/// The nodes are taken in farthest-point order of the first shape seen with this number of points, so any number of
/// them covers the membrane evenly; the node with the greatest force is always among them. Where few nodes bear a
/// force, as under a tool, the arrows are spread over those. Cost: points x MaximumCount once, then linear.
class ForceGlyphFilter : public vtkPolyDataAlgorithm {
 public:
  static ForceGlyphFilter* New();
  vtkTypeMacro(ForceGlyphFilter, vtkPolyDataAlgorithm);
  ForceGlyphFilter(const ForceGlyphFilter&) = delete;
  void operator=(const ForceGlyphFilter&) = delete;

  /// Most arrows drawn, 1..5000, default 250.
  vtkSetClampMacro(MaximumCount, int, 1, 5000);
  vtkGetMacro(MaximumCount, int);
  /// Forces below this share of the full scale get no arrow, 0..1, default 0.01.
  vtkSetClampMacro(ThresholdRatio, double, 0.0, 1.0);
  /// Force at which an arrow has the length LongestArrowUm, > 0.
  vtkSetMacro(FullScaleUN, double);
  /// Length of an arrow of full scale, > 0; a stronger force gets up to 1.5 times that.
  vtkSetMacro(LongestArrowUm, double);
  /// Arrow lengths by log10(1 + 99 f) / 2 of the full scale's share f, so that small forces show; default off.
  vtkSetMacro(LogScale, bool);

 protected:
  ForceGlyphFilter() = default;
  ~ForceGlyphFilter() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  void order_nodes(vtkPolyData* surface, const std::vector<vtkIdType>& candidates);
  double arrow_length_um(double magnitude_uN, double most_share = 1.5) const;

  int MaximumCount = 250;
  double ThresholdRatio = 0.01;
  double FullScaleUN = 1.0;
  double LongestArrowUm = 20.0;
  bool LogScale = false;

  std::vector<vtkIdType> order_, candidates_;  // of the surface with so many points
  vtkIdType ordered_point_count_ = -1;
  std::size_t ordered_for_ = 0;
};

/// The |force_uN| that a `share` (0..1) of the outer membrane's nodes that bear a force don't exceed: 1 gives the
/// greatest. 0 without forces.
double node_force_quantile_uN(vtkPolyData* surface, double share);

}  // namespace pellucida
