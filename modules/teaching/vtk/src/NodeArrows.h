#pragma once
#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>

#include <array>

#include "pellucida/teaching/NodeForces.h"
#include "pellucida/visualization/Palette.h"
#include "pellucida/visualization/Scaling.h"

class vtkRenderer;

namespace pellucida {

/// The forces on one node as arrows, one for each term and one for what they leave; all from the node, or head to tail,
/// where a balance closes to a ring.
class NodeArrows {
 public:
  void build(vtkRenderer* renderer);
  /// `longest_um`: length of the largest force's arrow.
  void show(const NodeForces& forces, const Eigen::Vector3d& node_um, double longest_um, bool head_to_tail,
            const ThemeColors& theme);
  void hide();
  /// Force of the longest arrow that the present scale allows, uN.
  double full_scale_uN() const noexcept { return range_uN_.upper(); }

 private:
  static constexpr std::size_t kCount = kForceTermCount + 1;  // the last: the residual
  struct Arrow {
    vtkNew<vtkTransform> pose;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void place(Arrow& arrow, const Eigen::Vector3d& from_um, const Eigen::Vector3d& along_um, double longest_um);

  vtkNew<vtkArrowSource> source_;
  std::array<Arrow, kCount> arrows_;
  vtkNew<vtkSphereSource> ball_;
  vtkNew<vtkPolyDataMapper> ball_mapper_;
  vtkNew<vtkActor> ball_actor_;
  NiceRange range_uN_{0.001};
};

}  // namespace pellucida
