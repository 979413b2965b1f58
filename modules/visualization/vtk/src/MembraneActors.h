#pragma once
#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkGeometryFilter.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkThreshold.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <array>

#include "ColorMap.h"
#include "ForceGlyphFilter.h"
#include "pellucida/core_vtk/SceneBlockFilter.h"
#include "pellucida/core_vtk/SceneData.h"

class vtkRenderer;

namespace pellucida {

/// A clear wall drawn far side first, then near side: right for a convex body without sorting its triangles.
struct ClearWall {
  vtkNew<vtkPolyDataMapper> mapper;
  std::array<vtkNew<vtkActor>, 2> sides;

  /// `glassy`: clear where one looks straight through, denser towards the rim.
  void build(vtkRenderer* renderer, const Color& color, double opacity, bool glassy = true);
  void show(bool shown) {
    for (auto& side : sides) side->SetVisibility(shown);
  }
  void set_opacity(double opacity) {
    for (auto& side : sides) side->GetProperty()->SetOpacity(opacity);
  }
};

/// The part of the surface that belongs to one membrane, smooth-shaded.
struct MembranePart {
  vtkNew<vtkThreshold> threshold;
  vtkNew<vtkGeometryFilter> geometry;
  vtkNew<vtkPolyDataNormals> normals;

  void build(vtkAlgorithmOutput* surface, Membrane which);
};

/// What the 3-D view draws, and how it comes from the scene: both membranes, the arrows on their nodes, the needle's
/// force as one bold arrow, the tools. What is shown of it, and with which scales, the view decides.
struct MembraneActors {
  static constexpr double kClearOpacity = 0.65;  ///< of the outer membrane where its colour says nothing

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

  /// Puts everything, hidden, into `renderer`; `scene` is a StageSource's output.
  void build(vtkAlgorithmOutput* scene, vtkRenderer* renderer);
  /// Takes the colours of the current theme.
  void follow_theme();
  /// The surface of the scene now; nullptr where it has none.
  vtkPolyData* update_surface() {
    surface->Update();
    return vtkPolyData::SafeDownCast(surface->GetOutputDataObject(0));
  }

 private:
  void build_membranes(vtkAlgorithmOutput* scene, vtkRenderer* renderer);
  void build_arrows(vtkRenderer* renderer);
};

}  // namespace pellucida
