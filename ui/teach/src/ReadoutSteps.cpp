#include "ReadoutSteps.h"

namespace pellucida {
namespace {

constexpr double kCurveStep_um = 2.0;
constexpr double kDeepest_um = 44.0;

}  // namespace

bool have_same_curves(const ReadoutParameters& a, const ReadoutParameters& b) {
  return a.noise_um == b.noise_um && a.contour == b.contour && a.laying == b.laying &&
         a.mesh_frequency == b.mesh_frequency && a.draw == b.draw;
}

expected<ReadoutPair, StepFailure> ContourReader::read(const ReadoutParameters& p, std::optional<int> node) {
  if (p.mesh_frequency != mesh_frequency_) {
    comparison_ = std::make_unique<ReadoutComparison>(p.mesh_frequency);
    mesh_frequency_ = p.mesh_frequency;
  }
  if (!is_of_finite_elements(p)) return comparison_->read(p, comparison_->own_section(p.depth_um), node);
  if (!reference_) reference_ = CellReference::load("thin-shell-oocyte", 1);
  const CellReference::Section section = reference_->section(p.depth_um);
  return comparison_->read(
      p, {section.outer_um, section.inner_um, reference_->angle_rad(), reference_->force_uN(p.depth_um)}, node);
}

expected<ReadoutPairPtr, StepFailure> ReadoutStep::process(const ReadoutOrder& order) {
  auto pair = reader_.read(order.parameters, order.node);
  if (!pair) return unexpected<StepFailure>(pair.error());
  return ReadoutPairPtr(std::make_shared<const ReadoutPair>(std::move(*pair)));
}

expected<ReadoutCurvesPtr, StepFailure> ReadoutCurveStep::process(const ReadoutParameters& parameters) {
  auto curves = std::make_shared<ReadoutCurves>();
  curves->parameters = parameters;
  ReadoutParameters p = parameters;
  for (p.depth_um = kCurveStep_um; p.depth_um <= kDeepest_um; p.depth_um += kCurveStep_um) {
    const auto pair = reader_.read(p, {});
    // The curve ends where the equilibrium does.
    if (!pair) break;
    curves->depth_um.push_back(p.depth_um);
    curves->true_uN.push_back(pair->true_force_uN);
    curves->equilibrium_uN.push_back(pair->equilibrium.force_uN);
    curves->prescribed_uN.push_back(pair->prescribed.force_uN);
  }
  return ReadoutCurvesPtr(std::move(curves));
}

}  // namespace pellucida
