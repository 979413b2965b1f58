#include "pellucida/teaching_vtk/SnakeView.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <cmath>
#include <numbers>

#include "FeedMarks.h"
#include "pellucida/core/Words.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

constexpr double kPointRadius_px = 2.2;
// Points nearer to each other than this on screen are not drawn one by one.
constexpr double kLeastPointDistance_px = 6.0;
constexpr int kStartDashes = 48;

}  // namespace

SnakeView::SnakeView() : FeedView(source) {
  show_legend(false);
  show_model_section(false);
  show_tools(false);
  set_framing(FeedFraming::kCell);
  set_empty_text(say("Preparing the picture"));
}

void SnakeView::set_picture(const Frozen<vtkImageData>& image) {
  image_ = image;
  set_snake(points_um_);
}

void SnakeView::set_snake(const Eigen::Matrix2Xd& points_um) {
  points_um_ = points_um;
  Scene scene;
  scene.frame = image_;
  if (image_ && points_um.cols() > 2) {
    Observation seen;
    seen.outer =
        MembraneContour{.membrane = Membrane::kOuter, .points_um = points_um, .sigma_um = {}, .confidence = {}};
    scene.membranes = Frozen<vtkPolyData>(make_membranes(seen));
  }
  source->SetScene(scene);
  refresh();
}

void SnakeView::set_start(const Eigen::Vector2d& center_um, double radius_um) {
  start_um_ = center_um;
  start_radius_um_ = radius_um;
}

Eigen::Vector2d SnakeView::place_on_picture_um(int x_px, int y_px) const {
  return place_um(x_px / hud_ratio(), height_px_ - 1.0 - y_px / hud_ratio(), height_px_);
}

Eigen::Vector2d SnakeView::place_on_screen_px(const Eigen::Vector2d& place_um) const {
  const double world_um[3] = {place_um.x(), place_um.y(), 0.0};
  const auto [x, y] = to_hud(world_um);
  return hud_ratio() * Eigen::Vector2d(x, y);
}

void SnakeView::draw_hud(HudCanvas& hud, double width_px, double height_px) {
  FeedView::draw_hud(hud, width_px, height_px);
  height_px_ = height_px;
  um_per_px_ = 2.0 * main_->GetActiveCamera()->GetParallelScale() / height_px;
  if (!image_) return;
  const auto place = [this](const Eigen::Vector2d& p_um) -> Eigen::Vector2d {
    return place_on_screen_px(p_um) / hud_ratio();
  };
  const auto on_start = [&](double turn) {
    const double angle_rad = 2.0 * std::numbers::pi * turn;
    return place(start_um_ + start_radius_um_ * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
  };
  for (int k = 0; k < kStartDashes; ++k) {
    const Eigen::Vector2d a = on_start(static_cast<double>(k) / kStartDashes), b = on_start((k + 0.55) / kStartDashes);
    hud.line(a.x(), a.y(), b.x(), b.y(), 1.5, palette::kInner);
  }
  const bool has_room =
      points_um_.cols() > 1 && (points_um_.col(1) - points_um_.col(0)).norm() / um_per_px_ > kLeastPointDistance_px;
  for (Eigen::Index i = 0; has_room && i < points_um_.cols(); ++i) {
    const Eigen::Vector2d p = place(points_um_.col(i));
    hud.disc(p.x(), p.y(), kPointRadius_px, palette::kText);
  }
  draw_legend(hud, {{say("Snake"), palette::kOuter}, {say("Where it began"), palette::kInner, true}}, width_px,
              height_px);
}

}  // namespace pellucida
