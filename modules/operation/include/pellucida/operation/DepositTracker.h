#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/haptics/Pipette.h"
#include "pellucida/simulation/SpecimenContact.h"

namespace pellucida {

/// What the injector has left in the cell in view, from its own record and from where the tip was: nothing of it is
/// measured in the image. A droplet grows while the tip stays in or at it, and moves with the cell's centre. Deposits
/// are forgotten once no cell has been in view for a second. One thread.
class DepositTracker {
 public:
  /// `center_um`: the cell's, frame W, image plane; nothing while no cell is in view. `time_s` never goes back. What is
  /// expelled while `state` is not kPunctured, or the pipette is unknown, is counted nowhere.
  void see(const PipetteState& pipette, CellState state, const std::optional<Eigen::Vector2d>& center_um,
           double time_s);
  /// Another cell: none of it is in that one.
  void forget() noexcept { droplets_.clear(); }

  /// Frame W, where the cell was seen last.
  std::vector<Droplet> droplets() const;

 private:
  void expel(double volume_pL, const Eigen::Vector3d& offset_um);

  std::vector<Droplet> droplets_;  // places from the cell's centre
  Eigen::Vector2d center_um_ = Eigen::Vector2d::Zero();
  double expelled_pL_ = -1.0;  // below 0: nothing reported yet
  double seen_s_ = 0.0;
};

}  // namespace pellucida
