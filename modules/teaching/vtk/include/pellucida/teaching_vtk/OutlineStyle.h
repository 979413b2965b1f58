#pragma once
#include <functional>

#include "pellucida/visualization_vtk/PanZoomStyle.h"

namespace pellucida {

/// Mouse over a picture on which something is drawn: the left button draws, the right one moves the picture, the wheel
/// zooms. Positions are device pixels of the window, origin at the bottom left.
class OutlineStyle : public PanZoomStyle {
 public:
  static OutlineStyle* New();
  vtkTypeMacro(OutlineStyle, PanZoomStyle);
  OutlineStyle(const OutlineStyle&) = delete;
  void operator=(const OutlineStyle&) = delete;

  std::function<void(int x_px, int y_px)> pressed;
  /// While the left button is down.
  std::function<void(int x_px, int y_px)> dragged;

  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override { held_ = false; }
  void OnMouseMove() override;
  void OnRightButtonDown() override { this->OnMiddleButtonDown(); }
  void OnRightButtonUp() override { this->OnMiddleButtonUp(); }

 protected:
  OutlineStyle() = default;
  ~OutlineStyle() override = default;

 private:
  bool held_ = false;
};

}  // namespace pellucida
