#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pellucida/core/PersonHint.h"
#include "pellucida/mechanics/ScaleMeasurement.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/tracking/TrackerOptions.h"

namespace pellucida {

/// Options of the chain; the defaults are those of the main job.
struct PipelineOptions {
  std::string profile = "mouse-oocyte";              ///< name of a shipped cell profile, or a file
  std::shared_ptr<const CellProfile> given_profile;  ///< instead, where set: the profile itself
  std::vector<ScaleMeasurement> scale_measurements;  ///< of this cell's own scale; aspirations with their modulus
  double revolve_step_deg = 10.0;                    ///< angular step of the revolved mesh, 1..120, a divisor of 360
  int meridian_point_count = 49;                     ///< points from pole to pole, >= 5
  TrackerOptions tracker;                            ///< of them, `quality` is the user's choice
  std::vector<PersonHint> hints;                     ///< to the tracking, in the order of time
  std::map<std::string, std::string> versions;  ///< of the program and its libraries, by name: for the record alone
};

}  // namespace pellucida
