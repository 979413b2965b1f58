#pragma once
#include <vtkInteractorStyleTrackballCamera.h>

#include <functional>

namespace pellucida {

/// Mouse over a cell to be poked: the left button drags the needle, a click with it picks; the right button turns the
/// scene, the middle one moves it, the wheel zooms. Positions are device pixels of the window, origin at the bottom
/// left.
class PokeStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static PokeStyle* New();
  vtkTypeMacro(PokeStyle, vtkInteractorStyleTrackballCamera);
  PokeStyle(const PokeStyle&) = delete;
  void operator=(const PokeStyle&) = delete;

  /// Called while the left button drags, with the way since the last call.
  std::function<void(int dx_px, int dy_px)> dragged;
  /// Nothing is there to be dragged: the left button turns the scene as well.
  bool turns_with_left = false;
  /// Called when the left button comes up where it went down.
  std::function<void(int x_px, int y_px)> clicked;

  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMouseMove() override;
  void OnRightButtonDown() override { vtkInteractorStyleTrackballCamera::OnLeftButtonDown(); }
  void OnRightButtonUp() override { vtkInteractorStyleTrackballCamera::OnLeftButtonUp(); }
  /// No keys: the window has its own.
  void OnChar() override {}

 protected:
  PokeStyle() = default;
  ~PokeStyle() override = default;

 private:
  bool held_ = false;
  bool moved_ = false;
  int start_px_[2] = {0, 0};
  int last_px_[2] = {0, 0};
};

}  // namespace pellucida
