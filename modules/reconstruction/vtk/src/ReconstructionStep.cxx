#include "pellucida/reconstruction_vtk/ReconstructionStep.h"

#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkTrivialProducer.h>

namespace pellucida {

static_assert(Step<ReconstructionStep>);

ReconstructionStep::ReconstructionStep(const RevolveOptions& options) {
  filter_->SetOptions(options);
  // A contour that can't be revolved is an expected outcome of a frame: its reason is read from the filter, so VTK's
  // own message about it is not wanted on the terminal.
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  filter_->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
}

expected<Scene, StepFailure> ReconstructionStep::process(const Scene& scene) {
  Scene result = scene;
  if (!scene.membranes || const_cast<vtkPolyData*>(scene.membranes.get())->GetNumberOfCells() == 0) return result;

  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(scene.membranes.shallow_copy());
  filter_->SetInputConnection(producer->GetOutputPort());
  filter_->Update();

  // A failure is reported once, when it begins, not with every frame it lasts.
  const bool failed = !filter_->GetFailure().empty();
  if (failed && !failing_) {
    result.events.push_back({scene.measurement.time_s, event_kind::kLost, "no surface: " + filter_->GetFailure()});
  }
  failing_ = failed;
  if (failed || filter_->GetOutput()->GetNumberOfPoints() == 0) return result;

  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->ShallowCopy(filter_->GetOutput());
  if (auto* volumes = surface->GetFieldData()->GetArray("volume_um3"); volumes && scene.observation->outer) {
    result.measurement.volume_um3 = volumes->GetComponent(0, 0);
  }
  result.surface = Frozen<vtkPolyData>(surface);
  return result;
}

}  // namespace pellucida
