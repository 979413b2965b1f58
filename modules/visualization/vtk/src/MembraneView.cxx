#include "pellucida/visualization_vtk/MembraneView.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>

#include "AxesTriad.h"
#include "ColorMap.h"
#include "MembraneActors.h"
#include "NodePick.h"
#include "ToolShapes.h"
#include "pellucida/core/Words.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kLongestArrowRatio = 0.35;  // of the cell's radius
constexpr double kContactArrowRatio = 0.8;
constexpr double kNeedleLengthRatio = 5.0;
// The colour scale ends where all but the few nodes at the tip are below; those are marked as beyond it.
constexpr double kScaleShare = 0.99;
constexpr double kHolderLengthRatio = 1.1;

bool has_membrane(vtkPolyData* surface, Membrane which) {
  vtkDataArray* membrane = surface ? surface->GetPointData()->GetArray(array_name::kMembrane) : nullptr;
  if (!membrane) return false;
  for (vtkIdType i = 0; i < membrane->GetNumberOfTuples(); ++i) {
    if (membrane->GetComponent(i, 0) == static_cast<int>(which)) return true;
  }
  return false;
}

// The array's greatest length or value; nothing when the surface lacks it.
double greatest_of(vtkPolyData* surface, const char* name) {
  vtkDataArray* array = surface ? surface->GetPointData()->GetArray(name) : nullptr;
  return array ? array->GetRange(array->GetNumberOfComponents() > 1 ? -1 : 0)[1] : -1.0;
}

std::string why_empty(const Scene& scene) {
  if (!scene.observation) return say("Waiting for a cell");
  return scene.observation->outer ? say("No surface: the contour can't be revolved") : say("No cell in sight");
}

}  // namespace

MembraneView::MembraneView(StageSource* source) : source_(source), actors_(std::make_unique<MembraneActors>()) {
  actors_->build(source_->GetOutputPort(), main_);

  main_->GradientBackgroundOn();
  follow_theme();
  // A key light over the shoulder and a weak fill from below.
  main_->AutomaticLightCreationOff();
  vtkNew<vtkLight> key;
  key->SetLightTypeToCameraLight();
  key->SetPosition(-0.6, 0.8, 1.0);
  key->SetIntensity(0.95);
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToCameraLight();
  fill->SetPosition(0.8, -0.5, 0.6);
  fill->SetIntensity(0.35);
  main_->AddLight(key);
  main_->AddLight(fill);
  refresh();
}

MembraneView::~MembraneView() = default;

void MembraneView::follow_theme() {
  main_->SetBackground(current_theme().view_bottom.data());
  main_->SetBackground2(current_theme().view_top.data());
  actors_->follow_theme();
}

void MembraneView::refresh() {
  MembraneActors& p = *actors_;
  vtkPolyData* surface = p.update_surface();
  has_surface_ = surface && surface->GetNumberOfPoints() > 0;
  p.outer_wall.show(has_surface_ && has_membrane(surface, Membrane::kOuter));
  p.inner_actor->SetVisibility(has_surface_ && has_membrane(surface, Membrane::kInner));

  // Where the cell is, from the outer membrane as it was found at rest where that is known.
  if (has_surface_) {
    const Scene& scene = source_->GetScene();
    double bounds_um[6];
    surface->GetBounds(bounds_um);
    for (int k = 0; k < 3; ++k) center_um_[k] = 0.5 * (bounds_um[2 * k] + bounds_um[2 * k + 1]);
    radius_um_ = 0.5 * (bounds_um[5] - bounds_um[4]);
    if (scene.observation && scene.observation->rest_outer_radius_um > 0.0) {
      center_um_[0] = scene.observation->center_um.x();
      center_um_[1] = scene.observation->center_um.y();
      radius_um_ = scene.observation->rest_outer_radius_um;
    }
    radius_um_ = std::max(radius_um_, 1e-3);
  }
  refresh_coloring(surface);
  refresh_arrows(surface);
  refresh_tools();
  refresh_contact_force();
  if (has_surface_ && !framed_) reset_camera();
}

void MembraneView::refresh_arrows(vtkPolyData* surface) {
  MembraneActors& p = *actors_;
  has_forces_ = has_surface_ && surface->GetPointData()->GetArray(array_name::kForce) != nullptr;
  p.glyph_actor->SetVisibility(arrows_shown_ && has_forces_);
  if (!has_forces_) return;
  // A free cell: nothing to draw, and no scale for it.
  has_forces_ = node_force_quantile_uN(surface, 1.0) > 0.0;
  if (!has_forces_) {
    p.glyph_actor->VisibilityOff();
    return;
  }
  const double upper_uN = force_range_uN_.update(node_force_quantile_uN(surface, kScaleShare));
  beyond_scale_ = node_force_quantile_uN(surface, 1.0) > upper_uN;
  p.force_colors->SetTableRange(0.0, upper_uN);
  p.glyphs->SetFullScaleUN(upper_uN);
  p.glyphs->SetLongestArrowUm(kLongestArrowRatio * radius_um_ * arrow_scale_);
  // With nothing left above the threshold the mapper would complain of missing arrays.
  p.glyphs->Update();
  if (p.glyphs->GetOutput()->GetNumberOfPoints() == 0) p.glyph_actor->VisibilityOff();
}

void MembraneView::refresh_coloring(vtkPolyData* surface) {
  MembraneActors& p = *actors_;
  const bool tension = coloring_ == SurfaceColoring::kTension;
  const char* array = tension ? array_name::kTension : array_name::kDisplacement;
  const double greatest = has_surface_ && coloring_ != SurfaceColoring::kPlain ? greatest_of(surface, array) : -1.0;
  coloring_available_ = greatest >= 0.0 && std::isfinite(greatest);
  p.outer_wall.mapper->SetScalarVisibility(coloring_available_);
  p.outer_wall.set_opacity(coloring_available_ ? 0.9 : MembraneActors::kClearOpacity);
  if (!coloring_available_) return;
  p.outer_wall.mapper->SelectColorArray(array);
  p.surface_colors->SetVectorModeToMagnitude();
  p.surface_colors->SetTableRange(0.0, (tension ? tension_range_uN_per_um_ : displacement_range_um_).update(greatest));
}

void MembraneView::refresh_tools() {
  MembraneActors& p = *actors_;
  const auto needle = needle_of(source_->GetScene());
  const auto holder = holder_of(source_->GetScene());
  p.needle.show(tools_shown_ && has_surface_ && needle.has_value());
  p.holder.show(tools_shown_ && has_surface_ && holder.has_value());
  if (needle) {
    p.needle.mapper->SetInputData(
        revolve_profile(needle_profile(*needle, kNeedleLengthRatio * radius_um_), needle->tip_um, -needle->direction));
  }
  if (holder) {
    p.holder.mapper->SetInputData(
        revolve_profile(holder_profile(*holder, kHolderLengthRatio * radius_um_), holder->mouth_um, holder->direction));
  }
}

// The needle's push on the cell: an arrow that ends at the tip.
void MembraneView::refresh_contact_force() {
  MembraneActors& p = *actors_;
  const Measurement& m = source_->GetScene().measurement;
  const auto needle = needle_of(source_->GetScene());
  const bool shown = has_surface_ && needle && std::isfinite(m.contact_force_uN) && m.contact_force_uN > 0.0;
  p.contact_actor->SetVisibility(shown);
  contact_label_ = shown ? readout::force(m) : std::string();
  if (!shown) return;
  const double full_um = kContactArrowRatio * radius_um_;
  const double length_um =
      std::max(full_um * m.contact_force_uN / contact_range_uN_.update(m.contact_force_uN), 0.02 * full_um);
  const Eigen::Vector2d tail_um = needle->tip_um - length_um * needle->direction;
  p.contact_pose->Identity();
  p.contact_pose->Translate(tail_um.x(), tail_um.y(), 0.0);
  p.contact_pose->RotateZ(std::atan2(needle->direction.y(), needle->direction.x()) * 180.0 / EIGEN_PI);
  // Thick enough to see when short: the width follows the full length.
  p.contact_pose->Scale(length_um, full_um, full_um);
  p.contact_arrow->SetTipLength(std::min(0.30 * full_um / length_um, 0.6));
  contact_tail_um_[0] = tail_um.x();
  contact_tail_um_[1] = tail_um.y();
}

void MembraneView::reset_camera() {
  vtkCamera* camera = main_->GetActiveCamera();
  // From the needle's side, so that one looks into the dimple.
  const Scene& scene = source_->GetScene();
  const Eigen::Vector2d axis = scene.observation ? scene.observation->axis : Eigen::Vector2d::UnitX();
  const double from[3] = {0.80 * axis.x(), 0.80 * axis.y() - 0.50, -1.0};
  const double length = std::sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]);
  constexpr double kViewAngle_deg = 24.0;
  const double distance_um = 1.6 * radius_um_ / std::sin(0.5 * kViewAngle_deg * EIGEN_PI / 180.0);
  camera->SetViewAngle(kViewAngle_deg);
  camera->SetFocalPoint(center_um_);
  camera->SetPosition(center_um_[0] + from[0] / length * distance_um, center_um_[1] + from[1] / length * distance_um,
                      center_um_[2] + from[2] / length * distance_um);
  camera->SetViewUp(0.0, -1.0, 0.0);
  framed_ = has_surface_;
}

void MembraneView::set_coloring(SurfaceColoring coloring) {
  coloring_ = coloring;
  refresh();
}

void MembraneView::show_arrows(bool shown) {
  arrows_shown_ = shown;
  refresh();
}

void MembraneView::show_tools(bool shown) {
  tools_shown_ = shown;
  refresh();
}

void MembraneView::set_arrow_count(int count) {
  actors_->glyphs->SetMaximumCount(count);
  refresh();
}

void MembraneView::set_arrow_scale(double scale) {
  arrow_scale_ = std::clamp(scale, 0.1, 5.0);
  refresh();
}

void MembraneView::set_arrow_threshold(double ratio) {
  actors_->glyphs->SetThresholdRatio(ratio);
  refresh();
}

void MembraneView::set_arrow_log_scale(bool on) {
  actors_->glyphs->SetLogScale(on);
  refresh();
}

std::optional<long> MembraneView::node_at(double x_px, double y_px) const {
  if (!has_surface_) return std::nullopt;
  const int* size = main_->GetSize();
  return pick_node(main_, x_px * hud_ratio(), size[1] - 1 - y_px * hud_ratio(), actors_->update_surface());
}

void MembraneView::set_empty_text(std::string utf8) {
  empty_text_ = std::move(utf8);
}

void MembraneView::mark_node(std::optional<long> node) {
  marked_node_ = node;
}

void MembraneView::prepare(double, double) {
  main_->ResetCameraClippingRange();
}

void MembraneView::draw_hud(HudCanvas& hud, double width_px, double height_px) {
  if (!has_surface_) {
    hud.text(0.5 * width_px, 0.5 * height_px, empty_text_.empty() ? why_empty(source_->GetScene()) : empty_text_,
             {.size_pt = font_size::kTitle, .color = current_theme().text_dim, .align = HudAlign::kCentre});
    return;
  }
  const double bar_height = std::clamp(0.38 * height_px, 90.0, 220.0);
  const double bar_y = height_px - bar_height - 46.0;
  if (arrows_shown_ && has_forces_) {
    draw_color_bar(hud, ColorMapKind::kForce, width_px - 16.0, bar_y, bar_height, force_range_uN_.upper(),
                   say("Node force (µN)"), HudAlign::kRight, beyond_scale_);
  }
  if (coloring_available_) {
    const bool tension = coloring_ == SurfaceColoring::kTension;
    draw_color_bar(hud, ColorMapKind::kSurface, 16.0, bar_y, bar_height,
                   (tension ? tension_range_uN_per_um_ : displacement_range_um_).upper(),
                   tension ? say("Tension (µN/µm)") : say("Displacement (µm)"), HudAlign::kLeft);
  }
  draw_axes_triad(hud, main_->GetActiveCamera());
  draw_contact_label(hud);
  draw_node_mark(hud);
}

void MembraneView::draw_contact_label(HudCanvas& hud) const {
  if (contact_label_.empty()) return;
  const auto [x, y] = to_hud(contact_tail_um_);
  const HudText style{
      .size_pt = font_size::kTitle, .color = current_theme().text, .bold = true, .align = HudAlign::kCentre};
  const double width = hud.text_width_px(contact_label_, style) + 18.0;
  hud.rounded(x - 0.5 * width, y + 22.0, width, 26.0, 5.0, current_theme().window, 0.78);
  hud.text(x, y + 35.0, contact_label_, style);
}

void MembraneView::draw_node_mark(HudCanvas& hud) const {
  vtkPolyData* surface = actors_->update_surface();
  if (!marked_node_ || *marked_node_ < 0 || *marked_node_ >= surface->GetNumberOfPoints()) return;
  const auto [x, y] = to_hud(surface->GetPoint(*marked_node_));
  hud.disc(x, y, 8.0, current_theme().window, 0.85);
  hud.disc(x, y, 6.0, current_theme().node_mark);
  hud.disc(x, y, 3.0, current_theme().window);
}

}  // namespace pellucida
