#include "MembraneActors.h"

#include <vtkDataObject.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace pellucida {
namespace {

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

}  // namespace

void ClearWall::build(vtkRenderer* renderer, const Color& color, double opacity, bool glassy) {
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
    if (glassy) make_glassy(side);
    renderer->AddActor(side);
  }
  sides[0]->GetProperty()->FrontfaceCullingOn();
  sides[1]->GetProperty()->BackfaceCullingOn();
}

void BoldArrow::build(vtkRenderer* renderer) {
  source->SetShaftRadius(0.05);
  source->SetTipRadius(0.14);
  source->SetTipLength(0.30);
  source->SetShaftResolution(20);
  source->SetTipResolution(28);
  mapper->SetInputConnection(source->GetOutputPort());
  actor->SetMapper(mapper);
  actor->SetUserTransform(pose);
  actor->PickableOff();
  actor->VisibilityOff();
  actor->GetProperty()->SetAmbient(0.55);
  actor->GetProperty()->SetDiffuse(0.50);
  renderer->AddActor(actor);
}

void BoldArrow::show(const Eigen::Vector3d& head, const Eigen::Vector3d& direction, double length_um, double full_um,
                     std::string value) {
  label = std::move(value);
  head_um = head;
  tail_um = head - length_um * direction;
  const Eigen::AngleAxisd turn(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), direction));
  pose->Identity();
  pose->Translate(tail_um.data());
  pose->RotateWXYZ(turn.angle() * 180.0 / EIGEN_PI, turn.axis().data());
  // A short one is thinner too, so that it stays an arrow; never so thin that it can't be seen.
  const double width_um = std::clamp(2.0 * length_um, 0.3 * full_um, full_um);
  pose->Scale(length_um, width_um, width_um);
  source->SetTipLength(std::min(0.30 * width_um / length_um, 0.6));
  actor->VisibilityOn();
}

void BoldArrow::hide() {
  label.clear();
  actor->VisibilityOff();
}

void MembranePart::build(vtkAlgorithmOutput* surface, Membrane which) {
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

void MembraneActors::build(vtkAlgorithmOutput* scene, vtkRenderer* renderer) {
  build_membranes(scene, renderer);
  build_arrows(renderer);
  build_droplets(renderer);
  // Clear bodies come after solid ones, the cell's skin before the glass.
  outer_wall.build(renderer, current_theme().outer_solid, kClearOpacity);
  holder.build(renderer, current_theme().glass, 0.75);
  needle.build(renderer, current_theme().glass, 0.80);
  follow_theme();
}

void MembraneActors::follow_theme() {
  const ThemeColors& theme = current_theme();
  for (auto& side : outer_wall.sides) set_color(side, theme.outer_solid);
  for (ClearWall* glass : {&holder, &needle}) {
    for (auto& side : glass->sides) set_color(side, theme.glass);
  }
  set_color(inner_actor, theme.inner_solid);
  for (BoldArrow* bold : {&needle_force, &holder_force}) set_color(bold->actor, theme.contact_force);
  set_color(model_actor, theme.model);
  set_color(bar_actor, theme.text);
  set_color(droplet_actor, theme.droplet);
  fill_lookup_table(force_colors, ColorMapKind::kForce);
  force_colors->SetNanColor(theme.unsure.red, theme.unsure.green, theme.unsure.blue, 1.0);
  fill_lookup_table(surface_colors, ColorMapKind::kSurface);
  fill_lookup_table(signed_colors, ColorMapKind::kPull);
}

void MembraneActors::build_membranes(vtkAlgorithmOutput* scene, vtkRenderer* renderer) {
  surface->SetBlock(SceneBlock::kSurface);
  surface->SetInputConnection(scene);
  outer.build(surface->GetOutputPort(), Membrane::kOuter);
  inner.build(surface->GetOutputPort(), Membrane::kInner);

  inner_mapper->SetInputConnection(inner.normals->GetOutputPort());
  inner_mapper->ScalarVisibilityOff();
  inner_actor->SetMapper(inner_mapper);
  inner_actor->PickableOff();
  inner_actor->VisibilityOff();
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

  model->SetBlock(SceneBlock::kModel);
  model->SetInputConnection(scene);
  model_mapper->SetInputConnection(model->GetOutputPort());
  model_mapper->ScalarVisibilityOff();
  model_actor->SetMapper(model_mapper);
  model_actor->GetProperty()->SetRepresentationToWireframe();
  model_actor->GetProperty()->LightingOff();
  model_actor->PickableOff();
  model_actor->VisibilityOff();
  renderer->AddActor(model_actor);
}

void MembraneActors::color_outer(bool colored) {
  if (colored == colored_) return;
  colored_ = colored;
  for (auto& side : outer_wall.sides) {
    // A clear wall would mix its colours with those behind it, and shadows with black: neither is on the scale.
    vtkProperty* property = side->GetProperty();
    property->SetOpacity(colored ? 1.0 : kClearOpacity);
    property->SetAmbient(colored ? 0.85 : 0.25);
    property->SetDiffuse(colored ? 0.15 : 0.75);
    property->SetSpecular(colored ? 0.0 : 0.35);
    side->SetForceTranslucent(!colored);
    side->SetForceOpaque(colored);
    side->GetShaderProperty()->ClearAllFragmentShaderReplacements();
    if (!colored) make_glassy(side);
  }
}

void MembraneActors::set_inner_clear(bool clear) {
  inner_actor->GetProperty()->SetOpacity(clear ? 0.35 : 1.0);
}

void MembraneActors::build_arrows(vtkRenderer* renderer) {
  // Two arrows of unit length: one that starts at its node, one that ends there.
  arrow->SetShaftRadius(0.05);
  arrow->SetTipRadius(0.14);
  arrow->SetTipLength(0.36);
  arrow->SetShaftResolution(8);
  arrow->SetTipResolution(12);
  back_one->Translate(-1.0, 0.0, 0.0);
  arrow_to_node->SetTransform(back_one);
  arrow_to_node->SetInputConnection(arrow->GetOutputPort());

  node_forces->SetInputConnection(surface->GetOutputPort());
  glyphs->SetInputConnection(node_forces->GetOutputPort());
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
  glyph_mapper->SelectColorArray("color_uN");
  glyph_mapper->SetLookupTable(force_colors);
  glyph_mapper->UseLookupTableScalarRangeOn();
  glyph_actor->SetMapper(glyph_mapper);
  glyph_actor->PickableOff();
  glyph_actor->VisibilityOff();
  glyph_actor->GetProperty()->SetAmbient(0.45);
  glyph_actor->GetProperty()->SetDiffuse(0.65);
  renderer->AddActor(glyph_actor);

  bars->SetInputConnection(glyphs->GetOutputPort());
  bar_mapper->SetInputConnection(bars->GetOutputPort());
  bar_mapper->ScalarVisibilityOff();
  bar_actor->SetMapper(bar_mapper);
  bar_actor->GetProperty()->LightingOff();
  bar_actor->PickableOff();
  bar_actor->VisibilityOff();
  renderer->AddActor(bar_actor);

  needle_force.build(renderer);
  holder_force.build(renderer);
}

void MembraneActors::build_droplets(vtkRenderer* renderer) {
  ball->SetRadius(1.0);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(16);
  droplet_mapper->SetInputData(droplets);
  droplet_mapper->SetSourceConnection(ball->GetOutputPort());
  droplet_mapper->SetScaleModeToScaleByMagnitude();
  droplet_mapper->SetScaleArray("radius_um");
  droplet_mapper->ScalarVisibilityOff();
  droplet_actor->SetMapper(droplet_mapper);
  droplet_actor->PickableOff();
  droplet_actor->VisibilityOff();
  droplet_actor->GetProperty()->SetAmbient(0.35);
  droplet_actor->GetProperty()->SetDiffuse(0.65);
  droplet_actor->GetProperty()->SetSpecular(0.3);
  droplet_actor->GetProperty()->SetSpecularPower(30.0);
  renderer->AddActor(droplet_actor);
}

}  // namespace pellucida
