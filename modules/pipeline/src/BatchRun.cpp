#include "pellucida/pipeline/BatchRun.h"

#include <cmath>
#include <thread>

#include "Chain.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Ring.h"
#include "pellucida/core/Stage.h"

namespace pellucida {
namespace {

constexpr std::size_t kQueueCount = 2;
constexpr double kRiskStep_um = 5.0;  // between the depths whose risk of puncture is reported

// How good a scene is for the one picture of a run: force first, then how much was seen, then what was refused as a
// cell.
double picture_score(const Scene& scene) {
  const Measurement& m = scene.measurement;
  if (!std::isnan(m.contact_force_uN) && m.contact_force_uN > 0.0) return 10.0 + m.contact_force_uN;
  if (scene.observation && scene.observation->refused_radius_um > 0.0) return 0.5;
  if (std::isnan(m.confidence)) return 0.0;
  return scene.observation && scene.observation->outer ? 1.0 + m.confidence : m.confidence;
}

// Runs one step and keeps how long it took.
template <class S>
auto timed(S& step, const typename S::Input& input, const Clock& clock, Distribution& step_us) {
  const double start_s = clock.now_s();
  auto output = step.process(input);
  step_us.add(1e6 * (clock.now_s() - start_s));
  return output;
}

// A failed step passes the scene on as it was, with the reason as an event.
Scene failed(Scene scene, const StepFailure& failure) {
  scene.events.push_back({scene.measurement.time_s, event_kind::kLost, failure.reason});
  return scene;
}

// The chain cut in two halves that may run side by side, as steps for a Stage.
struct TrackHalf {
  using Input = Scene;
  using Output = Scene;
  expected<Scene, StepFailure> process(const Scene& waiting) {
    // A recording doesn't age while it waits in a queue: a frame arrives when its turn comes.
    Scene scene = waiting;
    scene.arrival_s = clock.now_s();
    if (scene.use < FrameUse::kTrack) return scene;
    auto tracked = timed(chain.tracking, scene, clock, tracking_us);
    return tracked ? std::move(*tracked) : failed(std::move(scene), tracked.error());
  }
  Chain& chain;
  const Clock& clock;
  Distribution tracking_us;
};

struct ForceHalf {
  using Input = Scene;
  using Output = Scene;
  expected<Scene, StepFailure> process(const Scene& tracked) {
    if (tracked.use < FrameUse::kRevolve) return tracked;
    MeasuredScene measured{.scene = tracked, .estimate = {}};
    if (tracked.use >= FrameUse::kMeasure) {
      auto output = timed(chain.mechanics, tracked, clock, mechanics_us);
      measured = output ? std::move(*output) : MeasuredScene{failed(tracked, output.error()), {}};
      stamp_age(measured.scene, clock);
    }
    return timed(chain.surface, measured, clock, surface_us);
  }
  Chain& chain;
  const Clock& clock;
  Distribution mechanics_us;
  Distribution surface_us;
};

// What happens to each finished scene.
class Collector {
 public:
  Collector(BatchResult& result, const BatchOptions& options, std::optional<long> frame_count,
            const std::function<void(const Scene&)>& sink, const Clock& clock)
      : result_(result), options_(options), frame_count_(frame_count), sink_(sink), clock_(clock) {}

  void take(const Scene& scene) {
    result_.rows.push_back(scene.measurement);
    if (scene.measurement.state) ++result_.state_count[*scene.measurement.state];
    if (scene.use == FrameUse::kMeasure) result_.frame_to_force_us.add(1e3 * scene.measurement.frame_age_ms);
    if (const double score = picture_score(scene); !result_.peak || score > best_score_) {
      best_score_ = score;
      result_.peak = scene;
    }
    if (sink_) {
      const double start_s = clock_.now_s();
      sink_(scene);
      writing_us.add(1e6 * (clock_.now_s() - start_s));
    }
    if (options_.progress) options_.progress(static_cast<long>(result_.rows.size()), frame_count_);
  }

  Distribution writing_us;

 private:
  BatchResult& result_;
  const BatchOptions& options_;
  std::optional<long> frame_count_;
  const std::function<void(const Scene&)>& sink_;
  const Clock& clock_;
  double best_score_ = 0.0;
};

// Hands every frame to `give` until the source ends or breaks, or `give` wants no more.
void read_all(FrameSource& source, const Clock& clock, BatchResult& result, const std::function<bool(Scene)>& give) {
  try {
    while (auto frame = source.next()) {
      if (frame->damage.damaged && result.damaged_count++ == 0) {
        result.first_damage = std::to_string(frame->frame_index) + " (" + frame->damage.reason + ")";
      }
      if (!give(scene_of(*frame, clock.now_s(), 0))) return;
    }
  } catch (const Error&) {
    result.input_fault = std::current_exception();
  }
}

// Three threads beside the reading one; bounded queues between them make the faster wait for the slower.
void run_side_by_side(FrameSource& source, TrackHalf& track, ForceHalf& force, Collector& collector, const Clock& clock,
                      BatchResult& result) {
  Ring<Scene> to_track(kQueueCount);
  Ring<Scene> to_force(kQueueCount);
  Ring<Scene> done(kQueueCount);
  Stage track_stage(
      track, to_track, [&](Scene scene) { to_force.push_wait(std::move(scene)); }, clock);
  Stage force_stage(
      force, to_force, [&](Scene scene) { done.push_wait(std::move(scene)); }, clock);
  force_stage.start();
  track_stage.start();
  std::jthread reader([&] {
    read_all(source, clock, result, [&](Scene scene) { return to_track.push_wait(std::move(scene)); });
    to_track.close();
    track_stage.join();
    to_force.close();
    force_stage.join();
    done.close();
  });
  const auto close_all = [&] {
    to_track.close();
    to_force.close();
    done.close();
  };
  try {
    while (auto scene = done.wait({})) collector.take(*scene);
  } catch (...) {
    close_all();
    reader.join();
    throw;
  }
  reader.join();
  track_stage.rethrow();
  force_stage.rethrow();
}

}  // namespace

std::string damage_line(const BatchResult& result) {
  if (result.damaged_count == 0) return {};
  const bool one = result.damaged_count == 1;
  return "damaged  " + std::to_string(result.damaged_count) + (one ? " frame was" : " frames were") +
         " not decoded as recorded: kept, not measured; the first: " + result.first_damage + '\n';
}

BatchResult run_batch(FrameSource& source, const BatchOptions& options, const std::function<void(const Scene&)>& sink) {
  const SteadyClock clock;
  Chain chain(options.pipeline);
  BatchResult result;
  TrackHalf track{.chain = chain, .clock = clock};
  ForceHalf force{.chain = chain, .clock = clock};
  Collector collector(result, options, source.info().frame_count, sink, clock);

  if (options.job_count > 1) {
    run_side_by_side(source, track, force, collector, clock, result);
  } else {
    // Failures of the steps are events of the scene by now: the halves always give one.
    std::exception_ptr sink_fault;
    read_all(source, clock, result, [&](Scene scene) {
      const Scene finished = force.process(track.process(scene).value()).value();
      try {
        collector.take(finished);
      } catch (...) {
        sink_fault = std::current_exception();
      }
      return !sink_fault;
    });
    if (sink_fault) std::rethrow_exception(sink_fault);
  }
  result.step_us["tracking"] = track.tracking_us;
  result.step_us["mechanics"] = force.mechanics_us;
  result.step_us["surface"] = force.surface_us;
  result.step_us["writing"] = collector.writing_us;
  result.elapsed_s = clock.now_s();
  result.profile = chain.profile;
  result.cell_scale = chain.mechanics.scale();
  if (!options.pipeline.scale_measurements.empty()) result.puncture_risk = chain.mechanics.puncture_risk(kRiskStep_um);
  return result;
}

}  // namespace pellucida
