#include "pellucida/visualization_vtk/View.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "BlendingRenderer.h"

namespace pellucida {

View::View() : main_(vtk::TakeSmartPointer<vtkRenderer>(BlendingRenderer::New())) {
  main_->SetUseFXAA(true);
  main_->SetBackground(current_theme().view_bottom.data());
  // The camera of the upper renderer is never used: everything there is flat.
  over_->SetLayer(1);
  over_->InteractiveOff();
  over_->PreserveDepthBufferOff();
  hud_ = std::make_unique<HudCanvas>(over_);
  starts_->SetClientData(this);
  starts_->SetCallback(&View::on_start);
  main_->AddObserver(vtkCommand::StartEvent, starts_);
  over_->AddObserver(vtkCommand::StartEvent, starts_);
}

View::~View() {
  main_->RemoveObserver(starts_);
  over_->RemoveObserver(starts_);
}

vtkRenderer* View::renderer() const noexcept {
  return main_;
}

void View::add_to(vtkRenderWindow* window, const Viewport& viewport, double hud_ratio) {
  hud_ratio_ = hud_ratio;
  // One way of smoothing edges at a time: FXAA can't read a multisampled frame.
  if (window->GetMultiSamples() > 0) main_->SetUseFXAA(false);
  if (window->GetNumberOfLayers() < 2) window->SetNumberOfLayers(2);
  for (vtkRenderer* one : {main_.Get(), over_.Get()}) {
    one->SetViewport(viewport.x0, viewport.y0, viewport.x1, viewport.y1);
    window->AddRenderer(one);
  }
}

void View::follow_theme() {
  main_->SetBackground(current_theme().view_bottom.data());
}

void View::on_start(vtkObject* caller, unsigned long, void* self, void*) {
  auto* view = static_cast<View*>(self);
  const int* size = view->main_->GetSize();
  if (caller == view->main_) {
    view->prepare(size[0], size[1]);
    return;
  }
  view->hud_->begin(view->hud_ratio_);
  view->draw_hud(*view->hud_, size[0] / view->hud_ratio_, size[1] / view->hud_ratio_);
  view->hud_->end();
}

std::pair<double, double> View::to_hud(const double world_um[3]) const {
  double x = world_um[0];
  double y = world_um[1];
  double z = world_um[2];
  main_->WorldToView(x, y, z);
  main_->ViewToNormalizedViewport(x, y, z);
  const int* size = main_->GetSize();
  return {x * size[0] / hud_ratio_, y * size[1] / hud_ratio_};
}

}  // namespace pellucida
