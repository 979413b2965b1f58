#pragma once
#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkTransform.h>

#include <memory>

#include "ColorMap.h"
#include "MembraneActors.h"
#include "NodeArrows.h"
#include "pellucida/teaching/CellMesh.h"

class vtkRenderer;

namespace pellucida {

/// What the view of a poked cell draws.
struct PokedCellActors {
  static constexpr double kWallOpacity = 0.93;       ///< hides the connectors of the far side
  static constexpr double kExplainedOpacity = 0.35;  ///< while arrows may point inwards

  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPolyDataNormals> normals;
  ClearWall wall;

  vtkNew<vtkPolyData> springs;
  vtkNew<vtkDoubleArray> pulls_uN;  // one a connector
  vtkNew<vtkPolyDataMapper> spring_mapper;
  vtkNew<vtkActor> spring_actor;
  vtkSmartPointer<vtkLookupTable> pull_colors = make_lookup_table(ColorMapKind::kPull);

  vtkNew<vtkPolyData> field;
  vtkNew<vtkDoubleArray> field_uN;  // three a node
  vtkNew<vtkArrowSource> field_arrow;
  vtkNew<vtkGlyph3DMapper> field_mapper;
  vtkNew<vtkActor> field_actor;
  vtkSmartPointer<vtkLookupTable> field_colors = make_lookup_table(ColorMapKind::kForce);

  ClearWall needle;
  vtkNew<vtkTransform> needle_pose;
  ClearWall holder;
  NodeArrows arrows;

  /// Puts everything, hidden, into `renderer`.
  void build(vtkRenderer* renderer);
  /// Another mesh: triangles, connectors, tools.
  void set_mesh(std::shared_ptr<const CellMesh> mesh);
  /// Arrows of this length for a force of `full_uN`.
  void scale_field(double longest_um, double full_uN);
  void set_theme(const ThemeColors& theme, double spring_width_px);

  std::shared_ptr<const CellMesh> mesh;

 private:
  void build_field(vtkRenderer* renderer);
};

}  // namespace pellucida
