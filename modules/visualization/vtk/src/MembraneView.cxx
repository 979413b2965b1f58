#include "pellucida/visualization_vtk/MembraneView.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "MembraneActors.h"
#include "NodePick.h"
#include "ToolShapes.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kLongestArrowRatio = 0.35;  // of the cell's radius
constexpr double kContactArrowRatio = 0.8;
constexpr double kMostBoldShare = 1.5;  // of that
constexpr double kBarCrossRatio = 0.02;
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

// Least upper ends of the scales, so that noise doesn't fill them.
constexpr std::array kLeastForce_uN{0.05, 0.05, 0.05, 0.01, 0.01};  // in the order of NodeForceKind
constexpr std::array kLeastColor{1.0, 0.001, 1.0, 1.0};             // in the order of SurfaceColoring

const char* array_of(SurfaceColoring coloring) {
  switch (coloring) {
    case SurfaceColoring::kPlain:
      return nullptr;
    case SurfaceColoring::kTension:
      return array_name::kTension;
    case SurfaceColoring::kAreaStrain:
      return array_name::kAreaStrain;
    case SurfaceColoring::kDisplacement:
      break;
  }
  return array_name::kDisplacement;
}

// Sizes of the array's tuples, ascending up to the place that a scale ends at; empty when the surface lacks it.
std::vector<double> sizes_of(vtkPolyData* surface, const char* name) {
  vtkDataArray* array = surface && name ? surface->GetPointData()->GetArray(name) : nullptr;
  std::vector<double> sizes;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i) {
    double square = 0.0;
    for (int k = 0; k < array->GetNumberOfComponents(); ++k) square += std::pow(array->GetComponent(i, k), 2);
    if (std::isfinite(square)) sizes.push_back(std::sqrt(square));
  }
  return sizes;
}

// The sum of the surface's vectors.
Eigen::Vector3d sum_of(vtkPolyData* surface, const char* name) {
  vtkDataArray* array = surface ? surface->GetPointData()->GetArray(name) : nullptr;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), one;
  if (!array || array->GetNumberOfComponents() != 3) return sum;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    array->GetTuple(i, one.data());
    sum += one;
  }
  return sum;
}

Eigen::Vector3d in_space(const Eigen::Vector2d& in_plane) {
  return {in_plane.x(), in_plane.y(), 0.0};
}

}  // namespace

double MembraneView::Scale::update(double greatest, double time_s) {
  const double last = range.upper();
  range.update(greatest);
  if (used && range.upper() > last) {
    before = last;
    grew_s = time_s;
  }
  used = true;
  beyond = greatest > range.upper();
  return range.upper();
}

bool MembraneView::Scale::is_news(double time_s) const {
  constexpr double kNews_s = 3.0;
  return before > 0.0 && std::abs(time_s - grew_s) < kNews_s;
}

MembraneView::Scale& MembraneView::force_scale() {
  return force_scales_[static_cast<std::size_t>(node_force())];
}
MembraneView::Scale& MembraneView::color_scale() {
  return color_scales_[static_cast<std::size_t>(coloring_)];
}

MembraneView::MembraneView(StageSource* source) : source_(source), actors_(std::make_unique<MembraneActors>()) {
  for (std::size_t k = 0; k < force_scales_.size(); ++k) force_scales_[k].range = NiceRange(kLeastForce_uN[k]);
  for (std::size_t k = 0; k < color_scales_.size(); ++k) color_scales_[k].range = NiceRange(kLeastColor[k]);
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
  // What is in the cell is seen through the inner membrane.
  punctured_ = source_->GetScene().measurement.state == CellState::kPunctured;
  p.set_inner_clear(punctured_ || !droplets_.empty());
  p.droplet_actor->SetVisibility(has_surface_ && !droplets_.empty());
  const bool has_model = model_shown_ && has_surface_ && source_->GetScene().model;
  p.model_actor->SetVisibility(has_model);
  refresh_coloring(surface);
  refresh_arrows();
  refresh_tools();
  refresh_bold_arrows(surface);
  if (has_surface_ && !framed_) reset_camera();
}

void MembraneView::refresh_arrows() {
  MembraneActors& p = *actors_;
  p.glyph_actor->VisibilityOff();
  p.bar_actor->VisibilityOff();
  has_sure_ = has_unsure_ = false;
  vtkPolyData* forces = p.update_node_forces();
  const bool holds = has_surface_ && forces->GetPointData()->GetArray(array_name::kForce);
  lacks_force_ = has_surface_ && !holds && p.update_surface()->GetPointData()->GetArray(array_name::kForce);
  // A free cell: nothing to draw, and no scale for it.
  const double greatest_uN = holds ? node_force_quantile_uN(forces, 1.0) : 0.0;
  has_forces_ = greatest_uN > 0.0;
  if (!has_forces_) return;
  Scale& scale = force_scale();
  const double upper_uN =
      scale.update(node_force_quantile_uN(forces, kScaleShare), source_->GetScene().measurement.time_s);
  scale.beyond = greatest_uN > upper_uN;
  p.force_colors->SetTableRange(0.0, upper_uN);
  p.glyphs->SetFullScaleUN(upper_uN);
  p.glyphs->SetLongestArrowUm(kLongestArrowRatio * radius_um_ * arrow_scale_);
  p.bars->SetCrossUm(kBarCrossRatio * radius_um_);
  if (!arrows_shown_) return;
  // With nothing left above the threshold the mapper would complain of missing arrays.
  p.glyphs->Update();
  vtkPolyData* arrows = p.glyphs->GetOutput();
  p.glyph_actor->SetVisibility(arrows->GetNumberOfPoints() > 0);
  vtkDataArray* colors = arrows->GetPointData()->GetArray("color_uN");
  for (vtkIdType i = 0; colors && i < colors->GetNumberOfTuples(); ++i) {
    (std::isnan(colors->GetComponent(i, 0)) ? has_unsure_ : has_sure_) = true;
  }
  if (!bars_shown_) return;
  p.bars->Update();
  p.bar_actor->SetVisibility(p.bars->GetOutput()->GetNumberOfPoints() > 0);
}

void MembraneView::refresh_coloring(vtkPolyData* surface) {
  MembraneActors& p = *actors_;
  const char* array = array_of(coloring_);
  std::vector<double> sizes = sizes_of(has_surface_ ? surface : nullptr, array);
  coloring_available_ = !sizes.empty();
  p.outer_wall.mapper->SetScalarVisibility(coloring_available_);
  p.color_outer(coloring_available_);
  if (!coloring_available_) return;
  const auto end =
      sizes.begin() + static_cast<std::ptrdiff_t>(std::lround(kScaleShare * static_cast<double>(sizes.size() - 1)));
  std::nth_element(sizes.begin(), end, sizes.end());
  Scale& scale = color_scale();
  const double upper = scale.update(*end, source_->GetScene().measurement.time_s);
  scale.beyond = *std::max_element(end, sizes.end()) > upper;
  vtkLookupTable* colors = is_signed(coloring_) ? p.signed_colors : p.surface_colors;
  p.outer_wall.mapper->SetLookupTable(colors);
  p.outer_wall.mapper->SelectColorArray(array);
  colors->SetVectorModeToMagnitude();
  colors->SetTableRange(is_signed(coloring_) ? -upper : 0.0, upper);
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

// The needle's push on the cell, an arrow that ends at the tip; and what the holding pipette holds against it.
void MembraneView::refresh_bold_arrows(vtkPolyData* surface) {
  MembraneActors& p = *actors_;
  const Measurement& m = source_->GetScene().measurement;
  const auto needle = needle_of(source_->GetScene());
  const auto holder = holder_of(source_->GetScene());
  const bool shown = has_surface_ && needle && std::isfinite(m.contact_force_uN) && m.contact_force_uN > 0.0;
  contact_label_ = shown ? readout::force(m) : std::string();
  p.needle_force.hide();
  p.holder_force.hide();
  if (!shown) return;
  const double full_um = kContactArrowRatio * radius_um_;
  const double um_per_uN = full_um / contact_range_uN_.update(m.contact_force_uN);
  const auto length_um = [&](double force_uN) {
    return std::clamp(um_per_uN * force_uN, 0.02 * full_um, kMostBoldShare * full_um);
  };
  p.needle_force.show(in_space(needle->tip_um), in_space(needle->direction), length_um(m.contact_force_uN), full_um,
                      contact_label_);
  const bool of_holder = node_force() == NodeForceKind::kTools || node_force() == NodeForceKind::kHolder;
  const Eigen::Vector3d held_uN = sum_of(surface, array_name::kHolderForce);
  const double held = held_uN.norm();
  if (!of_holder || !arrows_shown_ || !holder || !(held > 0.0)) return;
  p.holder_force.show(in_space(holder->mouth_um), held_uN / held, length_um(held), full_um,
                      readout::number(held, 2) + " µN");
}

void MembraneView::reset_camera() {
  vtkCamera* camera = main_->GetActiveCamera();
  // From the needle's side, so that one looks into the dimple, and from above: as far as that isn't the needle's own
  // direction, whose arrow would be seen from its end.
  const Scene& scene = source_->GetScene();
  const Eigen::Vector2d axis = scene.observation ? scene.observation->axis : Eigen::Vector2d::UnitX();
  const Eigen::Vector2d up(0.0, -1.0), beside = up - up.dot(axis) * axis;
  const Eigen::Vector3d from(0.80 * axis.x() + 0.50 * beside.x(), 0.80 * axis.y() + 0.50 * beside.y(), -1.0);
  const double length = from.norm();
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

NodeForceKind MembraneView::node_force() const noexcept {
  return actors_->node_forces->GetKind();
}

const std::string& MembraneView::holder_label() const noexcept {
  return actors_->holder_force.label;
}

void MembraneView::set_node_force(NodeForceKind kind) {
  actors_->node_forces->SetKind(kind);
  refresh();
}

void MembraneView::show_error_bars(bool shown) {
  bars_shown_ = shown;
  refresh();
}

void MembraneView::show_model(bool shown) {
  model_shown_ = shown;
  refresh();
}

void MembraneView::set_droplets(std::vector<DropletMark> droplets) {
  droplets_ = std::move(droplets);
  vtkNew<vtkPoints> centers;
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radius_um");
  for (const DropletMark& droplet : droplets_) {
    centers->InsertNextPoint(droplet.center_um.data());
    radii->InsertNextValue(droplet.radius_um);
  }
  actors_->droplets->SetPoints(centers);
  actors_->droplets->GetPointData()->AddArray(radii);
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

}  // namespace pellucida
