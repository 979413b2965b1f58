#pragma once
#include <optional>
#include <string>

#include "pellucida/mechanics/PalpationUpdate.h"
#include "pellucida/tracking/TrackerOptions.h"

namespace pellucida {

/// What may be chosen about the chain; the defaults are the main job's.
struct PipelineOptions {
  std::string profile = "mouse-oocyte";  ///< name of a shipped cell profile, or a file
  std::optional<Palpation> palpation;    ///< what is known of this cell's stiffness from elsewhere
  double revolve_step_deg = 10.0;        ///< angular step of the revolved mesh, 1..120, a divisor of 360
  int meridian_point_count = 49;         ///< points from pole to pole, >= 5
  TrackerOptions tracker;                ///< of them, `quality` is the user's choice
};

}  // namespace pellucida
