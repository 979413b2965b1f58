#pragma once
#include <vtkNew.h>

#include "pellucida/core_vtk/Frozen.h"
#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization_vtk/FeedView.h"

class vtkImageData;

namespace pellucida {

/// What a SnakeView shows; a base, so that it is there before the view that follows it.
struct SnakeScene {
  vtkNew<StageSource> source;
};

/// A microscope's picture with a snake on it: the line in colour, its points, and the circle it began on, dashed.
class SnakeView : private SnakeScene, public FeedView {
 public:
  SnakeView();

  /// `image`: one component, 8 or 16 bit, spacing in um; null shows the empty text.
  void set_picture(const Frozen<vtkImageData>& image);
  /// (2 x n), um, closed.
  void set_snake(const Eigen::Matrix2Xd& points_um);
  void set_start(const Eigen::Vector2d& center_um, double radius_um);
  /// Where a place on screen (device pixels, origin at the bottom left) lies in the picture, um.
  Eigen::Vector2d place_on_picture_um(int x_px, int y_px) const;
  /// The other way.
  Eigen::Vector2d place_on_screen_px(const Eigen::Vector2d& place_um) const;
  /// Length of a logical pixel in the picture, um.
  double um_per_px() const { return um_per_px_; }

 protected:
  void draw_hud(HudCanvas& hud, double width_px, double height_px) override;

 private:
  Frozen<vtkImageData> image_;
  Eigen::Matrix2Xd points_um_;
  Eigen::Vector2d start_um_ = Eigen::Vector2d::Zero();
  double start_radius_um_ = 0.0;
  double height_px_ = 1.0;
  double um_per_px_ = 1.0;
};

}  // namespace pellucida
