#include "pellucida/visualization_vtk/MembraneView.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkFieldData.h>
#include <vtkGeometryFilter.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkThreshold.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ColorMap.h"
#include "ForceGlyphFilter.h"
#include "ToolShapes.h"
#include "pellucida/core_vtk/SceneBlockFilter.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kLongestArrowRatio = 0.35;  // of the cell's radius
constexpr double kContactArrowRatio = 0.8;
constexpr double kNeedleLengthRatio = 5.0;
// The colour scale ends where all but the few nodes at the tip are below; those are marked as beyond it.
constexpr double kScaleShare = 0.99;
constexpr double kClearOpacity = 0.65;
constexpr double kHolderLengthRatio = 1.1;

void set_color(vtkActor* actor, const Color& c) {
  actor->GetProperty()->SetColor(c.red, c.green, c.blue);
}

// Clear where one looks straight through, denser towards the rim, as a glass wall is.
void make_glassy(vtkActor* actor) {
  actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                           "  float rim = 1.0 - abs(normalVCVSOutput.z);\n"
                                                           "  opacity *= mix(0.30, 1.0, rim * rim);\n"
                                                           "//VTK::Light::Impl\n",
                                                           false);
}

// A clear wall drawn far side first, then near side: right for a convex body without sorting its triangles.
struct ClearWall {
  vtkNew<vtkPolyDataMapper> mapper;
  std::array<vtkNew<vtkActor>, 2> sides;

  void build(vtkRenderer* renderer, const Color& color, double opacity) {
    for (auto& side : sides) {
      side->SetMapper(mapper);
      set_color(side, color);
      side->GetProperty()->SetOpacity(opacity);
      side->GetProperty()->SetAmbient(0.25);
      side->GetProperty()->SetDiffuse(0.75);
      side->GetProperty()->SetSpecular(0.35);
      side->GetProperty()->SetSpecularPower(40.0);
      side->ForceTranslucentOn();
      side->VisibilityOff();
      side->PickableOff();
      make_glassy(side);
      renderer->AddActor(side);
    }
    sides[0]->GetProperty()->FrontfaceCullingOn();
    sides[1]->GetProperty()->BackfaceCullingOn();
  }
  void show(bool shown) {
    for (auto& side : sides) side->SetVisibility(shown);
  }
  void set_opacity(double opacity) {
    for (auto& side : sides) side->GetProperty()->SetOpacity(opacity);
  }
};

// The part of the surface that belongs to one membrane, smooth-shaded.
struct MembranePart {
  vtkNew<vtkThreshold> threshold;
  vtkNew<vtkGeometryFilter> geometry;
  vtkNew<vtkPolyDataNormals> normals;

  void build(vtkAlgorithmOutput* surface, Membrane which) {
    threshold->SetInputConnection(surface);
    threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array_name::kMembrane);
    threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_BETWEEN);
    threshold->SetLowerThreshold(static_cast<double>(which) - 0.5);
    threshold->SetUpperThreshold(static_cast<double>(which) + 0.5);
    geometry->SetInputConnection(threshold->GetOutputPort());
    normals->SetInputConnection(geometry->GetOutputPort());
    normals->SplittingOff();
    normals->ConsistencyOff();
  }
};

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

}  // namespace

struct MembraneView::Pipeline {
  vtkNew<SceneBlockFilter> surface;
  MembranePart outer;
  MembranePart inner;
  ClearWall outer_wall;
  vtkNew<vtkPolyDataMapper> inner_mapper;
  vtkNew<vtkActor> inner_actor;

  vtkNew<ForceGlyphFilter> glyphs;
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkTransform> back_one;
  vtkNew<vtkTransformPolyDataFilter> arrow_to_node;
  vtkNew<vtkGlyph3DMapper> glyph_mapper;
  vtkNew<vtkActor> glyph_actor;

  vtkNew<vtkArrowSource> contact_arrow;
  vtkNew<vtkTransform> contact_pose;
  vtkNew<vtkPolyDataMapper> contact_mapper;
  vtkNew<vtkActor> contact_actor;

  ClearWall needle;
  ClearWall holder;

  vtkSmartPointer<vtkLookupTable> force_colors = make_lookup_table(ColorMapKind::kForce);
  vtkSmartPointer<vtkLookupTable> surface_colors = make_lookup_table(ColorMapKind::kSurface);

  void build_membranes(vtkAlgorithmOutput* scene, vtkRenderer* renderer);
  void build_arrows(vtkRenderer* renderer);
  vtkPolyData* update_surface() {
    surface->Update();
    return vtkPolyData::SafeDownCast(surface->GetOutputDataObject(0));
  }
};

void MembraneView::Pipeline::build_membranes(vtkAlgorithmOutput* scene, vtkRenderer* renderer) {
  surface->SetBlock(SceneBlock::kSurface);
  surface->SetInputConnection(scene);
  outer.build(surface->GetOutputPort(), Membrane::kOuter);
  inner.build(surface->GetOutputPort(), Membrane::kInner);

  inner_mapper->SetInputConnection(inner.normals->GetOutputPort());
  inner_mapper->ScalarVisibilityOff();
  inner_actor->SetMapper(inner_mapper);
  inner_actor->PickableOff();
  inner_actor->VisibilityOff();
  set_color(inner_actor, palette::kInnerSolid);
  inner_actor->GetProperty()->SetAmbient(0.18);
  inner_actor->GetProperty()->SetDiffuse(0.80);
  inner_actor->GetProperty()->SetSpecular(0.12);
  inner_actor->GetProperty()->SetSpecularPower(18.0);
  renderer->AddActor(inner_actor);

  outer_wall.mapper->SetInputConnection(outer.normals->GetOutputPort());
  outer_wall.mapper->ScalarVisibilityOff();
  outer_wall.mapper->SetLookupTable(surface_colors);
  outer_wall.mapper->UseLookupTableScalarRangeOn();
  outer_wall.mapper->SetScalarModeToUsePointFieldData();
}

void MembraneView::Pipeline::build_arrows(vtkRenderer* renderer) {
  // Two arrows of unit length: one that starts at its node, one that ends there.
  arrow->SetShaftRadius(0.05);
  arrow->SetTipRadius(0.14);
  arrow->SetTipLength(0.36);
  arrow->SetShaftResolution(8);
  arrow->SetTipResolution(12);
  back_one->Translate(-1.0, 0.0, 0.0);
  arrow_to_node->SetTransform(back_one);
  arrow_to_node->SetInputConnection(arrow->GetOutputPort());

  glyphs->SetInputConnection(surface->GetOutputPort());
  glyph_mapper->SetInputConnection(glyphs->GetOutputPort());
  glyph_mapper->SetSourceConnection(0, arrow->GetOutputPort());
  glyph_mapper->SetSourceConnection(1, arrow_to_node->GetOutputPort());
  glyph_mapper->SourceIndexingOn();
  glyph_mapper->SetSourceIndexArray("arrow_kind");
  glyph_mapper->SetOrientationArray(array_name::kForce);
  glyph_mapper->SetOrientationModeToDirection();
  glyph_mapper->SetScaleModeToScaleByMagnitude();
  glyph_mapper->SetScaleArray("arrow_length_um");
  glyph_mapper->SetScaleFactor(1.0);
  glyph_mapper->SetScalarModeToUsePointFieldData();
  glyph_mapper->SelectColorArray("magnitude_uN");
  glyph_mapper->SetLookupTable(force_colors);
  glyph_mapper->UseLookupTableScalarRangeOn();
  glyph_actor->SetMapper(glyph_mapper);
  glyph_actor->PickableOff();
  glyph_actor->VisibilityOff();
  glyph_actor->GetProperty()->SetAmbient(0.45);
  glyph_actor->GetProperty()->SetDiffuse(0.65);
  renderer->AddActor(glyph_actor);

  contact_arrow->SetShaftRadius(0.05);
  contact_arrow->SetTipRadius(0.14);
  contact_arrow->SetTipLength(0.30);
  contact_arrow->SetShaftResolution(20);
  contact_arrow->SetTipResolution(28);
  contact_mapper->SetInputConnection(contact_arrow->GetOutputPort());
  contact_actor->SetMapper(contact_mapper);
  contact_actor->SetUserTransform(contact_pose);
  contact_actor->PickableOff();
  contact_actor->VisibilityOff();
  set_color(contact_actor, palette::kContactForce);
  contact_actor->GetProperty()->SetAmbient(0.55);
  contact_actor->GetProperty()->SetDiffuse(0.50);
  renderer->AddActor(contact_actor);
}

MembraneView::MembraneView(StageSource* source) : source_(source), pipeline_(std::make_unique<Pipeline>()) {
  Pipeline& p = *pipeline_;
  p.build_membranes(source_->GetOutputPort(), main_);
  p.build_arrows(main_);
  // Clear bodies come after solid ones, the cell's skin before the glass.
  p.outer_wall.build(main_, palette::kOuterSolid, kClearOpacity);
  p.holder.build(main_, palette::kGlass, 0.75);
  p.needle.build(main_, palette::kGlass, 0.80);

  main_->GradientBackgroundOn();
  main_->SetBackground(palette::kViewBottom.data());
  main_->SetBackground2(palette::kViewTop.data());
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

void MembraneView::refresh() {
  Pipeline& p = *pipeline_;
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
  Pipeline& p = *pipeline_;
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
  Pipeline& p = *pipeline_;
  const bool tension = coloring_ == SurfaceColoring::kTension;
  const char* array = tension ? array_name::kTension : array_name::kDisplacement;
  const double greatest = has_surface_ && coloring_ != SurfaceColoring::kPlain ? greatest_of(surface, array) : -1.0;
  coloring_available_ = greatest >= 0.0 && std::isfinite(greatest);
  p.outer_wall.mapper->SetScalarVisibility(coloring_available_);
  p.outer_wall.set_opacity(coloring_available_ ? 0.9 : kClearOpacity);
  if (!coloring_available_) return;
  p.outer_wall.mapper->SelectColorArray(array);
  p.surface_colors->SetVectorModeToMagnitude();
  p.surface_colors->SetTableRange(0.0, (tension ? tension_range_uN_per_um_ : displacement_range_um_).update(greatest));
}

void MembraneView::refresh_tools() {
  Pipeline& p = *pipeline_;
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
  Pipeline& p = *pipeline_;
  const Measurement& m = source_->GetScene().measurement;
  const auto needle = needle_of(source_->GetScene());
  const bool shown = has_surface_ && needle && std::isfinite(m.contact_force_uN) && m.contact_force_uN > 0.0;
  p.contact_actor->SetVisibility(shown);
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
  pipeline_->glyphs->SetMaximumCount(count);
  refresh();
}

void MembraneView::set_arrow_scale(double scale) {
  arrow_scale_ = std::clamp(scale, 0.1, 5.0);
  refresh();
}

void MembraneView::set_arrow_threshold(double ratio) {
  pipeline_->glyphs->SetThresholdRatio(ratio);
  refresh();
}

void MembraneView::set_arrow_log_scale(bool on) {
  pipeline_->glyphs->SetLogScale(on);
  refresh();
}

void MembraneView::prepare(double, double) {
  main_->ResetCameraClippingRange();
}

void MembraneView::draw_hud(HudCanvas& hud, double width, double height) {
  if (!has_surface_) {
    const bool measured = source_->GetScene().observation != nullptr;
    hud.text(0.5 * width, 0.5 * height, measured ? "No cell in sight" : "Waiting for a cell",
             {.size_pt = font_size::kTitle, .color = palette::kTextDim, .align = HudAlign::kCentre});
    return;
  }
  const double bar_height = std::clamp(0.38 * height, 90.0, 220.0);
  const double bar_y = height - bar_height - 46.0;
  if (arrows_shown_ && has_forces_) {
    draw_color_bar(hud, ColorMapKind::kForce, width - 16.0, bar_y, bar_height, force_range_uN_.upper(),
                   "Node force (µN)", HudAlign::kRight, beyond_scale_);
  }
  if (coloring_available_) {
    const bool tension = coloring_ == SurfaceColoring::kTension;
    draw_color_bar(hud, ColorMapKind::kSurface, 16.0, bar_y, bar_height,
                   (tension ? tension_range_uN_per_um_ : displacement_range_um_).upper(),
                   tension ? "Tension (µN/µm)" : "Displacement (µm)", HudAlign::kLeft);
  }
  draw_axes(hud);
  draw_contact_label(hud);
}

// A small triad in the lower left corner that turns with the camera.
void MembraneView::draw_axes(HudCanvas& hud) const {
  constexpr double kLength = 26.0;
  constexpr double kX = 44.0;
  constexpr double kY = 46.0;
  struct Axis {
    double direction[4];
    const char* name;
    Color color;
  };
  std::array<Axis, 3> axes = {{{{1.0, 0.0, 0.0, 0.0}, "x", Color::from_hex(0xFF8A80)},
                               {{0.0, 1.0, 0.0, 0.0}, "y", Color::from_hex(0x9BE58F)},
                               {{0.0, 0.0, 1.0, 0.0}, "z", Color::from_hex(0x8AB8FF)}}};
  vtkMatrix4x4* to_camera = main_->GetActiveCamera()->GetViewTransformMatrix();
  for (Axis& axis : axes) to_camera->MultiplyPoint(axis.direction, axis.direction);
  // The axis that points away from the eye is drawn first.
  std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.direction[2] < b.direction[2]; });
  for (const Axis& axis : axes) {
    const double x = kX + kLength * axis.direction[0];
    const double y = kY + kLength * axis.direction[1];
    hud.line(kX, kY, x, y, 2.0, axis.color);
    hud.text(kX + (kLength + 10.0) * axis.direction[0], kY + (kLength + 10.0) * axis.direction[1], axis.name,
             {.color = axis.color, .align = HudAlign::kCentre});
  }
}

void MembraneView::draw_contact_label(HudCanvas& hud) const {
  if (!pipeline_->contact_actor->GetVisibility()) return;
  const auto [x, y] = to_hud(contact_tail_um_);
  const std::string text = readout::force(source_->GetScene().measurement);
  const HudText style{.size_pt = font_size::kTitle, .color = palette::kText, .bold = true, .align = HudAlign::kCentre};
  const double width = hud.text_width(text, style) + 18.0;
  hud.rounded(x - 0.5 * width, y + 22.0, width, 26.0, 5.0, palette::kWindow, 0.78);
  hud.text(x, y + 35.0, text, style);
}

}  // namespace pellucida
