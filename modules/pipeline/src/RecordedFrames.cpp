#include "RecordedFrames.h"

#include <algorithm>
#include <utility>

#include "Chain.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/ObservationData.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "pellucida/session/FramesUsed.h"

namespace pellucida {
namespace {

/// What was recorded of one step but its image.
Scene recorded_scene(const SessionReader& session, std::size_t step) {
  Scene scene;
  scene.measurement = session.measurements()[step];
  scene.membranes = session.load(step, SessionPart::kMembranes);
  scene.tools = session.load(step, SessionPart::kTools);
  scene.surface = session.load(step, SessionPart::kSurface);
  return scene;
}

// The person's at the recording, and new ones, in the order of time.
std::vector<PersonHint> hints_of(const SessionReader& session, const CounterfactualOptions& options) {
  std::vector<PersonHint> hints = options.pipeline.hints;
  for (const Event& event : session.events()) {
    if (const auto hint = hint_of(event)) add_in_time(hints, *hint);
  }
  return hints;
}

std::optional<std::size_t> first_tracked(const SessionReader& session) {
  for (std::size_t i = 0; i < session.steps().size(); ++i) {
    if (session.measurements()[i].state && session.steps()[i].has(SessionPart::kMembranes)) return i;
  }
  return std::nullopt;
}

}  // namespace

bool has_observations(const SessionReader& session) {
  const auto step = first_tracked(session);
  if (!step) return false;
  const auto membranes = session.load(*step, SessionPart::kMembranes);
  const auto tools = session.load(*step, SessionPart::kTools);
  return read_observation(membranes.get(), tools.get()).has_value();
}

class RecordedFrames::Impl {
 public:
  Impl(const SessionReader& session, const CounterfactualOptions& options)
      : session_(session),
        used_(frames_used_of(session.info())),
        tables_only_(options.tables_only),
        tracking_(tracker_of(options.pipeline, profile_of(options.pipeline))),
        reconstruction_({.step_deg = options.pipeline.revolve_step_deg,
                         .meridian_point_count = options.pipeline.meridian_point_count}) {
    if (options.rerun == Rerun::kTracking) {
      for (const PersonHint& hint : hints_of(session, options)) tracking_.add_hint(hint);
      source_.emplace(session.folder(), options.playback);
      return;
    }
    if (!options.pipeline.hints.empty()) {
      throw UsageError("hints change the tracking, and only the mechanics would run again; give --rerun tracking");
    }
    if (options.playback.pixel_size_um) {
      throw UsageError("--pixel-size-um: contours are in um already; give --rerun tracking");
    }
    if (!has_observations(session)) {
      throw InputError(
          session.folder().string() +
          ": recorded without the numbers that the forces are computed from; give --rerun tracking, which " +
          "needs its images");
    }
    chosen_ = chosen_steps(session, options.playback);
    all_frames_ = options.playback.all_frames;
  }

  std::optional<RecordedFrame> next() {
    auto frame = source_ ? next_tracked() : next_recorded();
    if (frame && !tables_only_) frame->common = fields_.make(frame->scene, frame->recorded);
    return frame;
  }

  long expected_count() const noexcept {
    return source_ ? source_->info().frame_count.value_or(0) : static_cast<long>(chosen_.size());
  }

  long absent_count() const noexcept {
    return absent_count_ + (source_ ? source_->absent_count() + source_->damaged_count() : 0);
  }
  std::string first_absence() const {
    if (!first_absence_.empty() || !source_) return first_absence_;
    if (!source_->first_damage().empty()) return source_->first_damage();
    return source_->absent_count() > 0 ? "its image was not recorded" : "";
  }

 private:
  std::optional<RecordedFrame> next_tracked() {
    auto frame = source_->next();
    if (!frame) return std::nullopt;
    RecordedFrame out;
    out.scene = scene_of(*frame, 0.0, 0);
    // The recording's own events report what the source lost.
    out.scene.events.clear();
    const auto& steps = session_.steps();
    const auto step = std::lower_bound(steps.begin(), steps.end(), frame->frame_index,
                                       [](const SessionStep& one, long index) { return one.frame_index < index; });
    out.recorded = load(static_cast<std::size_t>(step - steps.begin()));
    if (frame->use >= FrameUse::kTrack) {
      if (auto tracked = tracking_.process(out.scene)) out.scene = std::move(*tracked);
    }
    revolve(out.scene);
    return out;
  }

  std::optional<RecordedFrame> next_recorded() {
    if (position_ == chosen_.size()) return std::nullopt;
    const std::size_t step = chosen_[position_++];
    RecordedFrame out;
    out.recorded = load(step);
    Scene& scene = out.scene;
    scene.measurement.frame = session_.steps()[step].frame_index;
    scene.measurement.time_s = session_.steps()[step].time_s;
    scene.run_index =
        used_ ? std::upper_bound(used_->run_starts.begin(), used_->run_starts.end(), scene.measurement.frame) -
                    used_->run_starts.begin()
              : 0;
    scene.use = recorded_use(session_, used_, step);
    if (all_frames_ && scene.use > FrameUse::kKeep) scene.use = FrameUse::kMeasure;
    if (scene.use == FrameUse::kKeep) return out;

    auto observation = read_observation(out.recorded.membranes.get(), out.recorded.tools.get());
    if (!observation) {
      note_absence("frame " + std::to_string(scene.measurement.frame) + ": its contours were not recorded");
      scene.use = FrameUse::kKeep;
      return out;
    }
    scene.membranes = out.recorded.membranes;
    scene.tools = out.recorded.tools;
    scene.measurement = measurement_from(*observation);
    scene.measurement.manipulator_x_um = out.recorded.measurement.manipulator_x_um;
    scene.measurement.manipulator_y_um = out.recorded.measurement.manipulator_y_um;
    if (scene.run_index != run_index_) state_.reset();
    run_index_ = scene.run_index;
    if (auto event = event_of_change(state_, *observation)) scene.events.push_back(std::move(*event));
    state_ = observation->state;
    scene.observation = std::make_shared<const Observation>(std::move(*observation));
    revolve(scene);
    return out;
  }

  void revolve(Scene& scene) {
    if (scene.use < FrameUse::kRevolve) return;
    if (auto revolved = reconstruction_.process(scene)) scene = std::move(*revolved);
  }

  // A part that can't be read is compared with nothing, and counted.
  Scene load(std::size_t step) {
    try {
      return recorded_scene(session_, step);
    } catch (const InputError& error) {
      note_absence(error.what());
      Scene scene;
      scene.measurement = session_.measurements()[step];
      return scene;
    }
  }

  void note_absence(const std::string& reason) {
    if (absent_count_++ == 0) first_absence_ = reason;
  }

  const SessionReader& session_;
  const std::optional<FramesUsed> used_;
  const bool tables_only_;
  CommonFieldsMaker fields_;
  TrackingStep tracking_;
  ReconstructionStep reconstruction_;
  std::optional<SessionSource> source_;  // where everything runs again
  std::vector<std::size_t> chosen_;      // where only the mechanics does
  std::size_t position_ = 0;
  bool all_frames_ = false;
  std::optional<CellState> state_;
  long run_index_ = 0;
  long absent_count_ = 0;
  std::string first_absence_;
};

RecordedFrames::RecordedFrames(const SessionReader& session, const CounterfactualOptions& options)
    : impl_(std::make_unique<Impl>(session, options)) {}
RecordedFrames::~RecordedFrames() = default;

long RecordedFrames::expected_count() const noexcept {
  return impl_->expected_count();
}
std::optional<RecordedFrame> RecordedFrames::next() {
  return impl_->next();
}
long RecordedFrames::absent_count() const noexcept {
  return impl_->absent_count();
}
std::string RecordedFrames::first_absence() const {
  return impl_->first_absence();
}

}  // namespace pellucida
