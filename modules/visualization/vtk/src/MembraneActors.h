#pragma once
#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkGeometryFilter.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkThreshold.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <Eigen/Core>
#include <array>
#include <string>

#include "ColorMap.h"
#include "ErrorBarFilter.h"
#include "ForceGlyphFilter.h"
#include "NodeForceFilter.h"
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

/// A force as one thick arrow that ends where it acts, with its value.
struct BoldArrow {
  vtkNew<vtkArrowSource> source;
  vtkNew<vtkTransform> pose;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  std::string label;  ///< empty: not drawn
  Eigen::Vector3d tail_um = Eigen::Vector3d::Zero(), head_um = Eigen::Vector3d::Zero();

  void build(vtkRenderer* renderer);
  /// `full_um`: length of an arrow of the scale's end; its width follows from it.
  void show(const Eigen::Vector3d& head, const Eigen::Vector3d& direction, double length_um, double full_um,
            std::string value);
  void hide();
};

/// What the 3-D view draws, and how it comes from the scene: both membranes, the arrows on their nodes, the tools and
/// their forces as bold arrows, deposited droplets, the model's mesh. What is shown of it, and with which scales, the
/// view decides.
struct MembraneActors {
  static constexpr double kClearOpacity = 0.65;  ///< of the outer membrane where its colour says nothing

  vtkNew<SceneBlockFilter> surface;
  MembranePart outer;
  MembranePart inner;
  ClearWall outer_wall;
  vtkNew<vtkPolyDataMapper> inner_mapper;
  vtkNew<vtkActor> inner_actor;

  vtkNew<SceneBlockFilter> model;
  vtkNew<vtkPolyDataMapper> model_mapper;
  vtkNew<vtkActor> model_actor;

  vtkNew<NodeForceFilter> node_forces;
  vtkNew<ForceGlyphFilter> glyphs;
  vtkNew<ErrorBarFilter> bars;
  vtkNew<vtkPolyDataMapper> bar_mapper;
  vtkNew<vtkActor> bar_actor;
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkTransform> back_one;
  vtkNew<vtkTransformPolyDataFilter> arrow_to_node;
  vtkNew<vtkGlyph3DMapper> glyph_mapper;
  vtkNew<vtkActor> glyph_actor;

  BoldArrow needle_force;
  BoldArrow holder_force;

  vtkNew<vtkPolyData> droplets;  // centres, radius_um
  vtkNew<vtkSphereSource> ball;
  vtkNew<vtkGlyph3DMapper> droplet_mapper;
  vtkNew<vtkActor> droplet_actor;

  ClearWall needle;
  ClearWall holder;

  vtkSmartPointer<vtkLookupTable> force_colors = make_lookup_table(ColorMapKind::kForce);
  vtkSmartPointer<vtkLookupTable> surface_colors = make_lookup_table(ColorMapKind::kSurface);
  vtkSmartPointer<vtkLookupTable> signed_colors = make_lookup_table(ColorMapKind::kPull);

  /// Puts everything, hidden, into `renderer`; `scene` is a StageSource's output.
  void build(vtkAlgorithmOutput* scene, vtkRenderer* renderer);
  /// Takes the colours of the current theme.
  void follow_theme();
  /// Colours the outer membrane so that what one sees is what its scale shows, or leaves it clear.
  void color_outer(bool colored);
  /// Solid, or clear enough to see a needle in it.
  void set_inner_clear(bool clear);
  /// The surface of the scene now; nullptr where it has none.
  vtkPolyData* update_surface() {
    surface->Update();
    return vtkPolyData::SafeDownCast(surface->GetOutputDataObject(0));
  }
  /// Its nodes with the force chosen.
  vtkPolyData* update_node_forces() {
    node_forces->Update();
    return node_forces->GetOutput();
  }

 private:
  void build_membranes(vtkAlgorithmOutput* scene, vtkRenderer* renderer);
  void build_arrows(vtkRenderer* renderer);
  void build_droplets(vtkRenderer* renderer);

  bool colored_ = false;
};

}  // namespace pellucida
