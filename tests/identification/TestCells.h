#pragma once
#include <numbers>

#include "pellucida/identification/ConstantsFit.h"
#include "pellucida/identification/Identification.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida::testing {

/// The shipped oocyte on a coarse mesh, at the published modulus, with its springs alone (what is fitted): quick, and
/// the same code.
inline CellProfile coarse_cell() {
  CellProfile cell = load_profile("mouse-oocyte");
  cell.effective_young_modulus_kPa = cell.young_modulus_kPa;
  cell.mesh_frequency = 4;
  cell.geometry_terms.clear();
  cell.geometry_pressure_terms.clear();
  return cell;
}

/// A curve made by the model itself, in the place of one by finite elements.
inline ReferenceCurve model_curve(const CellProfile& cell, int configuration, double max_um, double step_um) {
  ReferenceCurve curve;
  curve.configuration = configuration;
  curve.holder_angle_rad = configuration == 2   ? 0.25 * std::numbers::pi
                           : configuration == 3 ? 0.5 * std::numbers::pi
                                                : 0.0;
  curve.offset_um = configuration == 4 ? 10.0 : 0.0;
  const auto states = force_curve(cell, configuration, max_um, step_um);
  curve.depth_um.resize(static_cast<Eigen::Index>(states.size()));
  curve.force_uN.resize(curve.depth_um.size());
  for (std::size_t k = 0; k < states.size(); ++k) {
    curve.depth_um[static_cast<Eigen::Index>(k)] = states[k].depth_um;
    curve.force_uN[static_cast<Eigen::Index>(k)] = states[k].push_force_uN;
  }
  return curve;
}

}  // namespace pellucida::testing
