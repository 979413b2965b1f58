#include "Chain.h"

#include <string>
#include <utility>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/pipeline/RunProvenance.h"

namespace pellucida {

Chain::Chain(const PipelineOptions& options)
    : profile(profile_of(options)),
      tracking(tracker_of(options, profile)),
      mechanics(profile),
      surface{.reconstruction = ReconstructionStep(
                  {.step_deg = options.revolve_step_deg, .meridian_point_count = options.meridian_point_count}),
              .nodal_forces = {}} {
  for (const PersonHint& hint : options.hints) tracking.add_hint(hint);
  if (!options.scale_measurements.empty()) mechanics.set_scale_measurements(options.scale_measurements);
}

expected<Scene, StepFailure> SurfaceStep::process(const MeasuredScene& measured) {
  auto revolved = reconstruction.process(measured.scene);
  if (!revolved) return revolved;
  return nodal_forces.add_to(std::move(*revolved), measured.estimate);
}

Scene scene_of(const Frame& frame, double arrival_s, long run_index) {
  Scene scene;
  scene.arrival_s = arrival_s;
  scene.run_index = run_index + frame.run_index;
  scene.use = frame.use;
  scene.frame = frame.image;
  scene.measurement.frame = frame.frame_index;
  scene.measurement.time_s = frame.time_s;
  if (frame.manipulator_um) {
    scene.measurement.manipulator_x_um = frame.manipulator_um->x();
    scene.measurement.manipulator_y_um = frame.manipulator_um->y();
  }
  if (frame.gap_count > 0) {
    scene.events.push_back({frame.time_s, event_kind::kGap,
                            std::to_string(frame.gap_count) + " frames missing from the source before frame " +
                                std::to_string(frame.frame_index)});
  }
  const FrameDamage& damage = frame.damage;
  if (damage.damaged) scene.use = FrameUse::kKeep;
  if (damage.damaged && damage.count_before == 0) {
    scene.events.push_back({frame.time_s, event_kind::kDamaged,
                            "from frame " + std::to_string(frame.frame_index) + " on not decoded as recorded" +
                                (damage.reason.empty() ? "" : " (" + damage.reason + ")")});
  } else if (!damage.damaged && damage.count_before > 0) {
    scene.events.push_back(
        {frame.time_s, event_kind::kDamaged,
         "over, after " + std::to_string(damage.count_before) + (damage.count_before == 1 ? " frame" : " frames")});
  }
  return scene;
}

void number_on(Frame& frame, long index_offset, double time_offset_s) {
  frame.frame_index += index_offset;
  frame.time_s += time_offset_s;
  auto image = frame.image.shallow_copy();
  stamp(image, frame.time_s, frame.frame_index);
  frame.image = Frozen<vtkImageData>(image);
}

void stamp_age(Scene& scene, const Clock& clock) {
  scene.measurement.frame_age_ms = 1e3 * (clock.now_s() - scene.arrival_s);
}

}  // namespace pellucida
