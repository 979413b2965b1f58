#include "pellucida/teaching_vtk/PokeStyle.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <cstdlib>

namespace pellucida {
namespace {

// A hand that trembles this far still clicks.
constexpr int kClickSlack_px = 3;

}  // namespace

vtkStandardNewMacro(PokeStyle);

void PokeStyle::OnLeftButtonDown() {
  const int* at = this->Interactor->GetEventPosition();
  for (int k = 0; k < 2; ++k) start_px_[k] = last_px_[k] = at[k];
  held_ = true;
  moved_ = false;
  if (turns_with_left) OnRightButtonDown();
}

void PokeStyle::OnMouseMove() {
  if (!held_) {
    vtkInteractorStyleTrackballCamera::OnMouseMove();
    return;
  }
  const int* at = this->Interactor->GetEventPosition();
  const int dx = at[0] - last_px_[0], dy = at[1] - last_px_[1];
  moved_ |= std::abs(at[0] - start_px_[0]) > kClickSlack_px || std::abs(at[1] - start_px_[1]) > kClickSlack_px;
  if (!moved_) return;
  for (int k = 0; k < 2; ++k) last_px_[k] = at[k];
  if (turns_with_left) vtkInteractorStyleTrackballCamera::OnMouseMove();
  if (dragged) dragged(dx, dy);
}

void PokeStyle::OnLeftButtonUp() {
  if (turns_with_left) OnRightButtonUp();
  if (held_ && !moved_ && clicked) clicked(start_px_[0], start_px_[1]);
  held_ = false;
}

}  // namespace pellucida
