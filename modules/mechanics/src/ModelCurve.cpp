#include "pellucida/mechanics/ModelCurve.h"

#include "CellPlacement.h"
#include "GeometryEstimate.h"
#include "pellucida/core/Error.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

ModelCurve curve_of(Indenter& indenter, double deepest_um, double step_um, double force_ratio,
                    const std::function<bool()>& go_on) {
  if (!(deepest_um > 0.0) || !(step_um > 0.0)) throw UsageError("model curve: depth and step must be above 0");
  ModelCurve curve;
  for (int k = 0; k * step_um <= deepest_um + 1e-9; ++k) {
    const IndentationState state = indenter.advance_to(k * step_um);
    if (state.report.status != SolveStatus::kConverged) break;
    curve.indentation_um.push_back(k * step_um);
    curve.force_uN.push_back(force_ratio * state.push_force_uN);
    if (go_on && !go_on()) break;
  }
  return curve;
}

}  // namespace

std::optional<SeenCell> seen_cell(std::span<const Observation> frames, const CellProfile& profile) {
  GeometryEstimate geometry(profile);
  CellPlacement placement;
  bool seen = false;
  for (const Observation& frame : frames) {
    if (!frame.outer || !(frame.rest_outer_radius_um > 0.0) || !frame.center_um.allFinite()) continue;
    geometry.update(frame);
    placement.update(frame);
    seen = true;
  }
  if (!seen) return std::nullopt;
  return SeenCell{geometry.geometry(), placement.push(), placement.holder(), geometry.thickness_assumed(),
                  placement.holder_assumed()};
}

ModelCurve model_curve(const CellProfile& profile, const SeenCell& cell, double deepest_um, double step_um,
                       double force_ratio, const std::function<bool()>& go_on) {
  Indenter indenter(profile, cell.geometry, cell.push, cell.holder);
  return curve_of(indenter, deepest_um, step_um, force_ratio, go_on);
}

ModelCurve model_curve(const CellProfile& profile, double deepest_um, double step_um, double force_ratio,
                       const std::function<bool()>& go_on) {
  const MembraneSetup setup = setup_for_configuration(profile, 1);
  Indenter indenter(profile, geometry_of(profile), setup.push, setup.holder);
  return curve_of(indenter, deepest_um, step_um, force_ratio, go_on);
}

}  // namespace pellucida
