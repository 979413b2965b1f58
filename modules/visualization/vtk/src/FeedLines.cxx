#include "FeedLines.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <utility>

namespace pellucida {

void FeedLines::build(vtkAlgorithmOutput* input, vtkRenderer* renderer, int level) {
  under_ribbon->SetColors({palette::kWindow});
  under_ribbon->SetOpacity(0.6);
  for (auto [filter, one] : {std::pair{ribbon.Get(), actor.Get()}, std::pair{under_ribbon.Get(), under.Get()}}) {
    filter->SetInputConnection(input);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(filter->GetOutputPort());
    one->SetMapper(mapper);
    one->GetProperty()->LightingOff();
    // Blended in the order of drawing: the pass for clear things would mix a line with its underlay.
    one->ForceOpaqueOn();
    one->PickableOff();
    one->VisibilityOff();
  }
  // The camera looks along +z: smaller z is nearer.
  actor->SetPosition(0.0, 0.0, -2.0 * level);
  under->SetPosition(0.0, 0.0, -2.0 * level + 1.0);
  renderer->AddActor(under);
  renderer->AddActor(actor);
}

void FeedLines::set_width(double width, double um_per_px) {
  ribbon->SetWidthUm(width * um_per_px);
  under_ribbon->SetWidthUm((width + 2.0) * um_per_px);
  for (RibbonFilter* one : {ribbon.Get(), under_ribbon.Get()}) one->SetRimUm(1.2 * um_per_px);
}

}  // namespace pellucida
