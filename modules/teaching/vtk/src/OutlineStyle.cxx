#include "pellucida/teaching_vtk/OutlineStyle.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

namespace pellucida {

vtkStandardNewMacro(OutlineStyle);

void OutlineStyle::OnLeftButtonDown() {
  const int* at = this->Interactor->GetEventPosition();
  held_ = true;
  if (pressed) pressed(at[0], at[1]);
}

void OutlineStyle::OnMouseMove() {
  if (!held_) {
    PanZoomStyle::OnMouseMove();
    return;
  }
  const int* at = this->Interactor->GetEventPosition();
  if (dragged) dragged(at[0], at[1]);
}

}  // namespace pellucida
