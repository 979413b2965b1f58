#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pellucida/charts_vtk/CurveChart.h"
#include "presenters/RecordedSession.h"

namespace pellucida {

/// What the model says of one touch, to be laid under the force measured.
struct TouchModel {
  std::vector<NamedCurve> curves;  ///< force (uN) over indentation (um): of this cell as seen, of the profile's cell
  std::string remark;              ///< what the first takes from the profile, since no frame shows it; may be empty
};

/// Computes the model's curves for touch number `touch` of `session` (`touch_of`), as deep as it went: with the sizes
/// that the frames before it show, and for the profile's own cell. Reads some frames, then solves a step a micrometre.
/// `go_on` is asked now and then; false ends it with what there is. Any thread. No curve where the session has no
/// profile, the touch no depth.
TouchModel touch_model(const RecordedSession& session, std::size_t touch, const std::function<bool()>& go_on);

}  // namespace pellucida
