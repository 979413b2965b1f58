#pragma once
#include <string>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/simulation/Scenario.h"

namespace pellucida::test {

/// One frame of the virtual microscope through tracker and observer, beside the truth.
struct ForceFrame {
  double time_s = 0.0;
  CellState state = CellState::kNoCell, true_state = CellState::kNoCell;
  double depth_um = 0.0, true_depth_um = 0.0;             ///< as the tracker gives it
  double depth_sigma_um = 0.0;                            ///< likewise
  double force_uN = 0.0, true_force_uN = 0.0;             ///< 0 where nothing was measured
  double lower_uN = 0.0, upper_uN = 0.0;                  ///< the whole interval
  double picture_lower_uN = 0.0, picture_upper_uN = 0.0;  ///< of what the picture leaves open
  double scale_ratio = 0.0;                               ///< standard deviation of the scale's logarithm
  double offset_um = 0.0;    ///< of the cell's centre from the needle's line, in this frame alone
  bool is_measured = false;  ///< a force was given
  /// By the picture's interval: the virtual microscope's cells have the profile's stiffness.
  bool is_covered() const {
    return is_measured && picture_lower_uN <= true_force_uN && true_force_uN <= picture_upper_uN;
  }
  /// The share of cells of the kind, log-normal about the profile's stiffness with `scale_ratio`, whose force in this
  /// push, `true_force_uN` times their stiffness over the profile's, is in the whole interval.
  double covered_share_of_kind() const;
};

struct ForceRun {
  std::vector<ForceFrame> frames;
  std::vector<ForceEstimate> estimates;  ///< of the same frames, without the arrays of the shape
  double peak_uN = 0.0;                  ///< largest true force

  /// RMS of the force's error over all frames that hold a cell, in % of the largest true force.
  double rms_percent_of_peak() const;
  /// Frames truly in contact, and how many of them have the true force within the picture's 95 % interval.
  int contact_count() const;
  int covered_count() const;
  /// Mean of `covered_share_of_kind` over them.
  double covered_share_of_kind() const;
};

/// Every frame of a scenario through a fresh tracker and observer.
ForceRun run_force(const Scenario& scenario, const CellProfile& profile, const ForceOptions& options = {});

/// The profile that belongs to a scenario's cell.
CellProfile profile_of(const Scenario& scenario);

}  // namespace pellucida::test
