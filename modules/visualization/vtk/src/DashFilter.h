#pragma once
#include <vtkPolyDataAlgorithm.h>

namespace pellucida {

/// Cuts polylines into dashes, since the renderer draws no stipple.
/// Input port 0: vtkPolyData with lines. Output port 0: vtkPolyData with the dashes as polylines; no arrays.
/// Parameters: `DashUm` (default 3), `GapUm` (default 2), both > 0. Cost is linear in the points.
class DashFilter : public vtkPolyDataAlgorithm {
 public:
  static DashFilter* New();
  vtkTypeMacro(DashFilter, vtkPolyDataAlgorithm);
  DashFilter(const DashFilter&) = delete;
  void operator=(const DashFilter&) = delete;

  vtkSetClampMacro(DashUm, double, 1e-3, 1e6);
  vtkSetClampMacro(GapUm, double, 1e-3, 1e6);

 protected:
  DashFilter() = default;
  ~DashFilter() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  double DashUm = 3.0;
  double GapUm = 2.0;
};

}  // namespace pellucida
