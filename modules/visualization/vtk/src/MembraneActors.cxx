#include "MembraneActors.h"

#include <vtkDataObject.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

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
  set_color(contact_actor, theme.contact_force);
  fill_lookup_table(force_colors, ColorMapKind::kForce);
  fill_lookup_table(surface_colors, ColorMapKind::kSurface);
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
  contact_actor->GetProperty()->SetAmbient(0.55);
  contact_actor->GetProperty()->SetDiffuse(0.50);
  renderer->AddActor(contact_actor);
}

}  // namespace pellucida
