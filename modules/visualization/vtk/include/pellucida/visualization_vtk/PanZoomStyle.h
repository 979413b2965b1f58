#pragma once
#include <vtkInteractorStyleImage.h>

namespace pellucida {

/// Mouse over a flat image: drag pans, wheel zooms, nothing turns.
class PanZoomStyle : public vtkInteractorStyleImage {
 public:
  static PanZoomStyle* New();
  vtkTypeMacro(PanZoomStyle, vtkInteractorStyleImage);
  PanZoomStyle(const PanZoomStyle&) = delete;
  void operator=(const PanZoomStyle&) = delete;

  void OnLeftButtonDown() override { this->OnMiddleButtonDown(); }
  void OnLeftButtonUp() override { this->OnMiddleButtonUp(); }
  /// No keys: the window has its own.
  void OnChar() override {}

 protected:
  PanZoomStyle() = default;
  ~PanZoomStyle() override = default;
};

}  // namespace pellucida
