#pragma once
#include "pellucida/core/Clock.h"
#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/mechanics_vtk/MechanicsStep.h"
#include "pellucida/mechanics_vtk/NodalForces.h"
#include "pellucida/pipeline/PipelineOptions.h"
#include "pellucida/reconstruction_vtk/ReconstructionStep.h"
#include "pellucida/tracking_vtk/TrackingStep.h"

namespace pellucida {

/// What views draw of a measured scene: the membranes revolved, with the forces on their nodes, and the model's mesh.
struct SurfaceStep {
  using Input = MeasuredScene;
  using Output = Scene;
  expected<Scene, StepFailure> process(const MeasuredScene& measured);

  ReconstructionStep reconstruction;
  NodalForces nodal_forces;
};

/// The steps every run consists of: frame -> tracking -> mechanics -> surface. The force comes before the surface,
/// which it does not need. Live gives each a thread of its own, batch calls them one after the other; they are the same
/// objects with the same memory.
struct Chain {
  /// Throws UsageError for an unknown profile or an option out of range, InputError for a broken profile file.
  explicit Chain(const PipelineOptions& options);

  CellProfile profile;
  TrackingStep tracking;
  MechanicsStep mechanics;
  SurfaceStep surface;
};

/// A scene that holds only its frame, as it enters the chain. `run_index`: that of the run; the frame's own adds to it.
Scene scene_of(const Frame& frame, double arrival_s, long run_index);

/// After a restart numbers and times go on from where they were, in the image's stamp too.
void number_on(Frame& frame, long index_offset, double time_offset_s);

/// Stamps the age of the frame into the row: as soon as it has its force, or ends without one.
void stamp_age(Scene& scene, const Clock& clock);

}  // namespace pellucida
