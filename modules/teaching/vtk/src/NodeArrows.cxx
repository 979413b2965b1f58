#include "NodeArrows.h"

#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "pellucida/teaching_vtk/PokedCellView.h"

namespace pellucida {
namespace {

// Shorter arrows than this share of the longest are not drawn.
constexpr double kLeastArrow_ratio = 0.01;

}  // namespace

void NodeArrows::build(vtkRenderer* renderer) {
  source_->SetShaftRadius(0.5);
  source_->SetTipRadius(1.3);
  source_->SetTipLength(0.3);
  source_->SetShaftResolution(12);
  source_->SetTipResolution(16);
  for (Arrow& arrow : arrows_) {
    arrow.mapper->SetInputConnection(source_->GetOutputPort());
    arrow.actor->SetMapper(arrow.mapper);
    arrow.actor->SetUserTransform(arrow.pose);
    arrow.actor->GetProperty()->SetAmbient(0.55);
    arrow.actor->GetProperty()->SetDiffuse(0.5);
    arrow.actor->PickableOff();
    arrow.actor->VisibilityOff();
    renderer->AddActor(arrow.actor);
  }
  ball_->SetRadius(1.0);
  ball_mapper_->SetInputConnection(ball_->GetOutputPort());
  ball_actor_->SetMapper(ball_mapper_);
  ball_actor_->GetProperty()->SetAmbient(0.8);
  ball_actor_->PickableOff();
  ball_actor_->VisibilityOff();
  renderer->AddActor(ball_actor_);
}

void NodeArrows::hide() {
  for (Arrow& arrow : arrows_) arrow.actor->VisibilityOff();
  ball_actor_->VisibilityOff();
}

// The source points along x, one long and as thick as its radii say.
void NodeArrows::place(Arrow& arrow, const Eigen::Vector3d& from_um, const Eigen::Vector3d& along_um,
                       double longest_um) {
  const double length_um = along_um.norm();
  arrow.actor->SetVisibility(length_um > kLeastArrow_ratio * longest_um);
  if (!arrow.actor->GetVisibility()) return;
  const Eigen::AngleAxisd turn(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), along_um));
  const double thickness_um = std::min(0.03 * longest_um, 0.25 * length_um);
  arrow.pose->Identity();
  arrow.pose->Translate(from_um.data());
  arrow.pose->RotateWXYZ(turn.angle() * 180.0 / EIGEN_PI, turn.axis().data());
  arrow.pose->Scale(length_um, thickness_um, thickness_um);
}

void NodeArrows::show(const NodeForces& forces, const Eigen::Vector3d& node_um, double longest_um, bool head_to_tail,
                      const ThemeColors& theme) {
  double greatest_uN = 0.0;
  for (const auto& force_uN : forces.force_uN) greatest_uN = std::max(greatest_uN, force_uN.norm());
  const double um_per_uN = longest_um / range_uN_.update(greatest_uN);
  Eigen::Vector3d from_um = node_um;
  for (std::size_t k = 0; k < kCount; ++k) {
    const bool is_residual = k == kForceTermCount;
    const Eigen::Vector3d along_um = um_per_uN * (is_residual ? forces.residual_uN() : forces.force_uN[k]);
    // What is left runs from the node to where the chain ends.
    place(arrows_[k], is_residual ? node_um : from_um, along_um, longest_um);
    const Color color = is_residual ? theme.record : term_color(static_cast<ForceTerm>(k), theme);
    arrows_[k].actor->GetProperty()->SetColor(color.red, color.green, color.blue);
    if (head_to_tail && !is_residual) from_um += along_um;
  }
  ball_->SetRadius(0.06 * longest_um);
  ball_actor_->SetPosition(node_um.x(), node_um.y(), node_um.z());
  ball_actor_->GetProperty()->SetColor(theme.text.red, theme.text.green, theme.text.blue);
  ball_actor_->VisibilityOn();
}

}  // namespace pellucida
