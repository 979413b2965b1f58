#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "pellucida/charts_vtk/CurveChart.h"
#include "presenters/SurfaceNode.h"

namespace pellucida {

/// One node of the membrane through a whole session. A step without a surface, or whose file can't be read, has NaN.
struct NodeHistory {
  long node = 0;
  std::vector<double> times_s;      ///< one a step read, in order
  std::vector<SurfaceNode> states;  ///< likewise
  std::size_t unreadable_count = 0;
  bool whole = false;  ///< false: the reading was ended before the last step
};

/// Reads every surface of the session, one after another (some ms each). `go_on` is asked with (steps read, all steps)
/// after each; false ends the reading, and what was read so far is returned. Any thread. Throws InputError when there
/// is no session.
NodeHistory read_node_history(const std::filesystem::path& session, long node,
                              const std::function<bool(std::size_t, std::size_t)>& go_on);

/// One array of the node over time; the force with its 95 % interval where the session has sigmas.
CurveChartData node_over_time(const NodeHistory& history, NodeArray array);

/// One array along the meridian of `surface` that holds node `number`, on its membrane: over the angle at the cell's
/// centre from the needle's axis, at rest, in degrees. Empty where the surface lacks axis, rest directions or node.
CurveChartData along_meridian(vtkPolyData* surface, long number, NodeArray array);
/// That angle for one node; NaN where it is unknown.
double polar_angle_deg(vtkPolyData* surface, long number);

}  // namespace pellucida
