#pragma once
#include <vtkPolyDataAlgorithm.h>

namespace pellucida {

/// The 95 % interval of each arrow's force, as a line with a cross at each end along the arrow, at its free end.
/// Input port 0: vtkPolyData, the output of ForceGlyphFilter. Output port 0: vtkPolyData, lines; none where an arrow's
/// deviation isn't known.
class ErrorBarFilter : public vtkPolyDataAlgorithm {
 public:
  static ErrorBarFilter* New();
  vtkTypeMacro(ErrorBarFilter, vtkPolyDataAlgorithm);
  ErrorBarFilter(const ErrorBarFilter&) = delete;
  void operator=(const ErrorBarFilter&) = delete;

  /// Half the width of the crosses, > 0.
  vtkSetMacro(CrossUm, double);

 protected:
  ErrorBarFilter() = default;
  ~ErrorBarFilter() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  double CrossUm = 1.0;
};

}  // namespace pellucida
