#include "Chain.h"

#include <string>

#include "pellucida/pipeline/RunProvenance.h"

namespace pellucida {

Chain::Chain(const PipelineOptions& options)
    : profile(profile_of(options)),
      tracking(options.tracker),
      reconstruction({.step_deg = options.revolve_step_deg, .meridian_point_count = options.meridian_point_count}),
      mechanics(profile) {
  if (options.palpation) mechanics.set_palpation(*options.palpation);
}

Scene scene_of(const Frame& frame, double arrival_s, long run_index) {
  Scene scene;
  scene.arrival_s = arrival_s;
  scene.run_index = run_index + frame.run_index;
  scene.use = frame.use;
  scene.frame = frame.image;
  scene.measurement.frame = frame.frame_index;
  scene.measurement.time_s = frame.time_s;
  if (frame.gap_count > 0) {
    scene.events.push_back({frame.time_s, event_kind::kGap,
                            std::to_string(frame.gap_count) + " frames missing from the source before frame " +
                                std::to_string(frame.frame_index)});
  }
  return scene;
}

void stamp_age(Scene& scene, const Clock& clock) {
  scene.measurement.frame_age_ms = 1e3 * (clock.now_s() - scene.arrival_s);
}

}  // namespace pellucida
