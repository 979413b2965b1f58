#pragma once
#include <vtkPolyDataAlgorithm.h>

#include "pellucida/visualization/NodeForce.h"

namespace pellucida {

/// One kind of force on the nodes of a surface.
/// Input port 0: vtkPolyData, the surface as `MechanicsStep` leaves it.
/// Output port 0: vtkPolyData, its points with
///   | array          | type   | comp. | what                                                                     |
///   | membrane       | as is  | 1     | as in the input                                                          |
///   | force_uN       | double | 3     | the force chosen; the array is missing where the surface doesn't hold it |
///   | force_sigma_uN | double | 1     | its standard deviation; missing where unknown                            |
/// The pressure's force is minus the sum of all others. Its deviation is the membrane's where no tool touches, and in
/// the same proportion (the median) under the tools, where the membrane's says how a tool's force is spread.
class NodeForceFilter : public vtkPolyDataAlgorithm {
 public:
  static NodeForceFilter* New();
  vtkTypeMacro(NodeForceFilter, vtkPolyDataAlgorithm);
  NodeForceFilter(const NodeForceFilter&) = delete;
  void operator=(const NodeForceFilter&) = delete;

  void SetKind(NodeForceKind kind);
  NodeForceKind GetKind() const { return kind_; }

 protected:
  NodeForceFilter() = default;
  ~NodeForceFilter() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  NodeForceKind kind_ = NodeForceKind::kTools;
};

}  // namespace pellucida
