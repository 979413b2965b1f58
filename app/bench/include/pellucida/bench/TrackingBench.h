#pragma once
#include <map>
#include <string>

#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/pipeline/Distribution.h"

namespace pellucida {

/// What the tracker alone costs, us: frames in memory, one thread, warm.
struct TrackingFigures {
  Distribution frame_us;                         ///< a frame whose predecessor was followed
  Distribution detect_us;                        ///< a first frame: the whole image is searched
  std::map<std::string, Distribution> parts_us;  ///< of `frame_us`: needle, rigid, contours, report
  double frames_per_s = 0.0;
};

/// Reads up to 300 frames of `source`, then tracks them forth and back for `seconds`, and searches the first one anew
/// for a fifth of that time, at least five times. Throws NothingMeasuredError when there is no frame.
TrackingFigures measure_tracking(FrameSource& source, double seconds);

}  // namespace pellucida
