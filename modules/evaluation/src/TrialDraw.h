#pragma once
#include <cstdint>

#include "pellucida/simulation/SimulatedHand.h"

namespace pellucida {

/// What the seed of a trial draws of its operator.
struct DrawnOperator {
  OperatorOptions options;
  ArmOptions arm;
  double insertion_speed_um_per_s = 40.0;
};

/// The simulated operator of a seed: the defaults of OperatorOptions and ArmOptions, each spread evenly by about a
/// quarter to either side (tremor from 50 to 150 um, within what the header's source finds). The same operator whatever
/// the modality, so that modalities are compared within operators.
DrawnOperator draw_operator(std::uint64_t seed, Modality modality);

/// Where a trial's scene lies: small differences from trial to trial, by its seed.
struct Placement {
  double center_x_um = 0.0, center_y_um = 0.0;  ///< of the cell, beside the scenario's place: -5..5
  double turn_deg = 0.0;                        ///< of the whole scene: -20..20
  double start_back_um = 0.0;                   ///< of the tip before the approach point: 20..40
  double start_across_um = 0.0;                 ///< in the image plane: -15..15
  double start_out_um = 0.0;                    ///< out of it: -15..15
};
Placement draw_placement(std::uint64_t seed);

}  // namespace pellucida
