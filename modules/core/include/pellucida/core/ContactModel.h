#pragma once
#include <type_traits>

#include "pellucida/core/Observation.h"
#include "pellucida/core/PlainVector.h"

namespace pellucida {

/// The contact as measured in the newest frame, for the 1 kHz thread: the force on the needle and how it changes with
/// the tip's motion, about the place where the tip was seen. Trivially copyable: it goes through `LatestValue`. Frame
/// W, um, uN, s.
struct ContactModel {
  double time_s = 0.0;    ///< when the frame arrived, on the run's clock: the force's age counts from it
  long frame_index = -1;  ///< -1: no frame yet
  bool valid = false;     ///< the numbers below were measured; false: the frame gave no force
  CellState state = CellState::kNoCell;
  double confidence = 0.0;  ///< of the frame, 0..1

  PlainVector3 tip_um;    ///< where the tip was in that frame
  PlainVector3 push;      ///< unit vector of the needle's push, from the shaft to the tip
  PlainVector3 force_uN;  ///< of the cell on the needle (against the push): what a hand at the needle would feel
  double force_sigma_uN = 0.0;
  double stiffness_uN_per_um = 0.0;  ///< tangent stiffness along the push, >= 0
  double damping_uN_s_per_um = 0.0;  ///< along the push, >= 0
  double depth_um = 0.0;             ///< indentation

  bool cell_seen = false;  ///< the three below are valid
  PlainVector3 center_um;  ///< centre of the outer membrane at rest
  double outer_radius_um = 0.0;
  double inner_radius_um = 0.0;  ///< 0: not seen
  bool holder_seen = false;      ///< the two below are valid
  PlainVector3 holder_mouth_um;
  PlainVector3 holder_direction;  ///< unit vector from the cell's centre to the mouth
};
static_assert(std::is_trivially_copyable_v<ContactModel>);

}  // namespace pellucida
