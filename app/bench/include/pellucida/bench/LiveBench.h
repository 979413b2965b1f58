#pragma once
#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/pipeline/Distribution.h"
#include "pellucida/pipeline/PipelineOptions.h"

namespace pellucida {

/// How old a frame is when its force is known, us, in a live run at the camera's own pace.
struct LiveFigures {
  Distribution frame_to_force_us;
  Distribution search_us;  ///< of each run's first frame, in which the whole image is searched, and of those meanwhile
  long skipped_count = 0;  ///< frames that a newer one overtook, most of them meanwhile
};

/// Holds the first 300 frames of `source` in memory and runs them live, again and again until `seconds` have passed;
/// the last run is cut off there, after 20 frames at the earliest. Throws NothingMeasuredError when there is no frame.
LiveFigures measure_live(FrameSource& source, const PipelineOptions& options, double seconds);

}  // namespace pellucida
