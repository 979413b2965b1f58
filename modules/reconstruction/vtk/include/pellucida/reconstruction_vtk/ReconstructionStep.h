#pragma once
#include <vtkNew.h>

#include "pellucida/core/Step.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/reconstruction_vtk/RevolveFilter.h"

namespace pellucida {

/// Adds the revolved membranes (`Scene::surface`) and the enclosed volume to a tracked scene. A scene without contours,
/// or with contours that can't be revolved, is passed on without a surface; the reason of the latter becomes an event.
class ReconstructionStep {
 public:
  using Input = Scene;
  using Output = Scene;

  /// Throws UsageError when an option is out of its range.
  explicit ReconstructionStep(const RevolveOptions& options);
  expected<Scene, StepFailure> process(const Scene& scene);

 private:
  vtkNew<RevolveFilter> filter_;
  bool failing_ = false;
};

}  // namespace pellucida
