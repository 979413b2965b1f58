#pragma once
#include <vtkDataObjectAlgorithm.h>

#include "pellucida/core_vtk/StageSource.h"

namespace pellucida {

/// Extracts one part of a scene from a StageSource's output, as the plain vtkImageData or vtkPolyData that ordinary
/// filters and mappers accept. Input port 0: vtkMultiBlockDataSet. Output port 0: the block's data; an empty object of
/// its type when the scene lacks that part.
class SceneBlockFilter : public vtkDataObjectAlgorithm {
 public:
  static SceneBlockFilter* New();
  vtkTypeMacro(SceneBlockFilter, vtkDataObjectAlgorithm);
  SceneBlockFilter(const SceneBlockFilter&) = delete;
  void operator=(const SceneBlockFilter&) = delete;

  void SetBlock(SceneBlock block);
  SceneBlock GetBlock() const { return block_; }

 protected:
  SceneBlockFilter() = default;
  ~SceneBlockFilter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  SceneBlock block_ = SceneBlock::kMembranes;
};

}  // namespace pellucida
