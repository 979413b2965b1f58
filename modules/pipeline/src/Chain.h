#pragma once
#include "pellucida/core/Clock.h"
#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/mechanics_vtk/MechanicsStep.h"
#include "pellucida/pipeline/PipelineOptions.h"
#include "pellucida/reconstruction_vtk/ReconstructionStep.h"
#include "pellucida/tracking_vtk/TrackingStep.h"

namespace pellucida {

/// The steps every run consists of: frame -> tracking -> reconstruction -> mechanics. Live gives each a thread of its
/// own, batch calls them one after the other; they are the same objects with the same memory.
struct Chain {
  /// Throws UsageError for an unknown profile or an option out of range, InputError for a broken profile file.
  explicit Chain(const PipelineOptions& options);

  CellProfile profile;
  TrackingStep tracking;
  ReconstructionStep reconstruction;
  MechanicsStep mechanics;
};

/// A scene that holds only its frame, as it enters the chain. `run_index`: that of the run; the frame's own adds to it.
Scene scene_of(const Frame& frame, double arrival_s, long run_index);

/// Stamps the age of the frame into the row: the last thing that happens to a scene before it is published.
void stamp_age(Scene& scene, const Clock& clock);

}  // namespace pellucida
