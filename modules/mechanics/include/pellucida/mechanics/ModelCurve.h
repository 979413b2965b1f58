#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/membrane/MembraneGeometry.h"

namespace pellucida {

/// A cell and the tools on it as frames show them; what they don't show is the profile's.
struct SeenCell {
  MembraneGeometry geometry;
  Eigen::Vector3d push = -Eigen::Vector3d::UnitZ();    ///< unit, frame C: the way the needle pushes
  Eigen::Vector3d holder = -Eigen::Vector3d::UnitZ();  ///< unit, frame C: from the centre to the holder
  bool thickness_assumed = false;                      ///< the inner membrane was not seen at rest
  bool holder_assumed = false;                         ///< no holder was seen
};

/// What the force estimate would take from these frames of one cell, in the order of time, up to the touch; nothing
/// where none shows a membrane at rest.
std::optional<SeenCell> seen_cell(std::span<const Observation> frames, const CellProfile& profile);

/// A force-indentation curve of the model alone: elastic, pushed slowly.
struct ModelCurve {
  std::vector<double> indentation_um;  ///< 0, step, 2 step, ... as far as there is an equilibrium
  std::vector<double> force_uN;        ///< as long; of the needle on the cell, along the push
};

/// The curve of a cell of the profile's kind with these sizes. `force_ratio`: the cell's own stiffness over its kind's.
/// `go_on` is asked after each step; false ends the curve there. Some ms a step. Throws UsageError unless
/// `deepest_um` and `step_um` are above 0.
ModelCurve model_curve(const CellProfile& profile, const SeenCell& cell, double deepest_um, double step_um,
                       double force_ratio = 1.0, const std::function<bool()>& go_on = {});
/// The curve of the profile's own cell, pushed opposite the holder.
ModelCurve model_curve(const CellProfile& profile, double deepest_um, double step_um, double force_ratio = 1.0,
                       const std::function<bool()>& go_on = {});

}  // namespace pellucida
