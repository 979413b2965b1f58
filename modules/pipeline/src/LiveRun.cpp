#include "pellucida/pipeline/LiveRun.h"

#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "Chain.h"
#include "GrowingLog.h"
#include "LiveClock.h"
#include "LiveScale.h"
#include "ReaderPace.h"
#include "RunRecording.h"
#include "pellucida/core/Ring.h"
#include "pellucida/core/Stage.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/pipeline/RunProvenance.h"

namespace pellucida {
namespace {
// Every measured frame is published, in its order: so many may wait for their surface.
constexpr std::size_t kMeasuredCount = 3;
}  // namespace

class LiveRun::Impl {
 public:
  using SceneExchange = SharedLatest<Scene>;

  Impl(std::unique_ptr<FrameSource> source, PipelineOptions options, double speed_ratio)
      : source_(std::move(source)),
        info_(source_->info()),
        can_restart_(source_->restart()),
        options_(std::move(options)),
        chain_(options_),
        pace_(clock_, speed_ratio) {}

  ~Impl() { stop(); }

  void start() {
    surface_stage_.start();
    force_stage_.start();
    track_stage_.start();
    reader_ = std::jthread([this](std::stop_token stop) { read(stop); });
  }

  void stop() {
    reader_.request_stop();
    if (reader_.joinable()) reader_.join();
    track_stage_.stop();
    force_stage_.stop();
    // What has its force gets its surface too.
    to_surface_.close();
    surface_stage_.join();
    try {
      stop_recording();
    } catch (const std::exception& error) {
      set_fault(error.what());
      recording_fault_ = std::current_exception();
    }
  }

  // The reader: takes frames at their time and starts them on their way.
  void read(std::stop_token stop) {
    try {
      for (;;) {
        switch (pace_.next_turn(stop)) {
          case ReaderTurn::kStop:
            return;
          case ReaderTurn::kRestart:
            begin_anew();
            break;
          case ReaderTurn::kPaused:
            add_event({newest_time_s(), event_kind::kPaused, ""});
            break;
          case ReaderTurn::kResumed:
            resumed_ = true;
            break;
          case ReaderTurn::kRead:
            read_frame(stop);
            break;
        }
      }
    } catch (const std::exception& error) {
      set_fault(error.what());
      pace_.end();
    }
  }

  void read_frame(std::stop_token stop) {
    auto frame = source_->next();
    if (!frame) {
      pace_.end();
    } else if (info_.live || pace_.wait_until_due(frame->time_s, stop)) {
      hand_out(std::move(*frame));
    }
  }

  void begin_anew() {
    source_->restart();
    run_index_ = last_run_index_ + 1;
    index_offset_ = next_index_;
    time_offset_s_ = next_time_s_;
    source_clock_.begin_anew();
  }

  void hand_out(Frame frame) {
    if (run_index_ > 0) number_on(frame, index_offset_, time_offset_s_);
    if (resumed_) tell_resumed(frame);
    next_index_ = frame.frame_index + 1;
    next_time_s_ = frame.time_s + 1.0 / info_.frame_rate_hz;
    const double arrival_s = clock_.now_s();
    source_clock_.add(frame.time_s, arrival_s);
    if (!frame.manipulator_um) frame.manipulator_um = manipulator_.at(frame.time_s + source_clock_.lag_s());
    const Scene scene = scene_of(frame, arrival_s, run_index_);
    last_run_index_ = scene.run_index;
    ++frame_count_;
    gap_count_ += static_cast<std::uint64_t>(frame.gap_count);
    recording_.announce(scene);
    frames_->publish(scene);
    if (frame.damage.damaged) {
      skip(scene);
    } else if (auto skipped = to_track_.publish(scene)) {
      skip(*skipped);
    }
  }

  // What a live source showed during a pause was left out on purpose: no loss of the source's.
  void tell_resumed(Frame& frame) {
    resumed_ = false;
    add_event({frame.time_s, event_kind::kResumed,
               frame.gap_count > 0 ? std::to_string(frame.gap_count) + " frames were not taken during the pause" : ""});
    frame.gap_count = 0;
  }

  // A newer frame came first: this one is kept with what is known of it so far, be it nothing but its image.
  void skip(const Scene& scene) {
    ++skipped_count_;
    for (const Event& event : scene.events) events_.append(event);
    recording_.settle(scene);
  }

  // A step had nothing to say of this frame: it is kept with the reason.
  void keep_failed(const Scene& scene, const StepFailure& failure) {
    Scene failed = scene;
    failed.events.push_back({scene.measurement.time_s, event_kind::kLost, failure.reason});
    stamp_age(failed, clock_);
    publish(std::move(failed));
  }

  // The force is known, on the mechanics' thread: the hand gets to know of the frame before anyone sees it.
  void pass_on(MeasuredScene measured) {
    if (contact_sink_) contact_sink_(measured.scene.contact);
    stamp_age(measured.scene, clock_);
    scale_.take(measured.scene.events);
    to_surface_.push_wait(std::move(measured));
  }

  // The end of the chain: what everybody else sees.
  void publish(Scene scene) {
    newest_arrival_s_ = scene.arrival_s;
    rows_.append(scene.measurement);
    for (const Event& event : scene.events) events_.append(event);
    recording_.settle(scene);
    scenes_->publish(std::move(scene));
    ++measured_count_;  // last: who sees the count finds the scene
  }

  void start_recording(const std::filesystem::path& folder) {
    SessionInfo info;
    info.source = info_;
    info.profile_name = chain_.profile.name;
    info.profile_json = to_json(chain_.profile);
    info.drop_policy = kDropPolicy;
    info.seeds = info_.seeds;
    info.clock_offsets_s = source_clock_.offsets(clock_.now_s());
    scale_.record();
    RunProvenance provenance;
    provenance.frames_before_recording = static_cast<long>(frame_count_);
    info.provenance_json = to_json(provenance, options_, chain_.profile);
    recording_.start(folder, info, {newest_time_s(), event_kind::kStarted, "recording of " + info_.name});
  }

  void stop_recording() {
    recording_.set_clocks(source_clock_.json());
    recording_.stop({newest_time_s(), event_kind::kStopped, "recording"});
  }

  bool note(const std::string& text) {
    const Event note{newest_time_s(), event_kind::kNote, text};
    events_.append(note);
    return recording_.note(note);
  }

  void add_event(const Event& event) {
    events_.append(event);
    recording_.event(event);
  }

  double newest_time_s() const {
    const auto newest = frames_->peek();
    return newest ? newest->measurement.time_s : 0.0;
  }

  LiveStatus status() {
    LiveStatus status;
    status.frame_count = frame_count_;
    status.measured_count = measured_count_;
    status.skipped_count = skipped_count_;
    status.gap_count = gap_count_;
    status.tracking_ms = 1e3 * track_stage_.counts().last_step_s;
    status.mechanics_ms = 1e3 * force_stage_.counts().last_step_s;
    status.surface_ms = 1e3 * surface_stage_.counts().last_step_s;
    status.frame_age_ms = measured_count_ > 0 ? 1e3 * (clock_.now_s() - newest_arrival_s_) : 0.0;
    status.pace = pace_.figures();
    status.finished = pace_.ended() && measured_count_ + skipped_count_ >= frame_count_;
    const RecordingStatus recording = recording_.status();
    status.recording = recording.recording;
    status.recording_folder = recording.folder;
    status.recorded_count = recording.recorded_count;
    status.recorder_dropped_count = recording.dropped_count;
    status.recorder_thinned_count = recording.thinned_count;
    status.waiting_note_count = recording.waiting_note_count;
    status.fault = recording.fault;
    if (!status.fault) status.fault = fault();
    return status;
  }

  void set_fault(const std::string& text) {
    std::lock_guard lock(fault_mutex_);
    if (!fault_) fault_ = text;
  }

  std::optional<std::string> fault() const {
    try {
      track_stage_.rethrow();
      surface_stage_.rethrow();
      force_stage_.rethrow();
    } catch (const std::exception& error) {
      return error.what();
    }
    std::lock_guard lock(fault_mutex_);
    return fault_;
  }

  // Passes a scene on to the next exchange; one it overtakes there counts as skipped.
  Stage<TrackingStep, SceneExchange>::Sink into(SceneExchange& exchange) {
    return [this, &exchange](Scene scene) {
      if (auto skipped = exchange.publish(std::move(scene))) skip(*skipped);
    };
  }

  std::function<void(const ContactModel&)> contact_sink_;
  std::unique_ptr<FrameSource> source_;
  const SourceInfo info_;
  const bool can_restart_;
  const SteadyClock clock_;
  const PipelineOptions options_;
  Chain chain_;

  const std::shared_ptr<SceneExchange> frames_ = std::make_shared<SceneExchange>();
  const std::shared_ptr<SceneExchange> scenes_ = std::make_shared<SceneExchange>();
  SceneExchange to_track_;
  SceneExchange to_force_;
  Ring<MeasuredScene> to_surface_{kMeasuredCount};
  ManipulatorTrack manipulator_;
  GrowingLog<Measurement> rows_;
  GrowingLog<Event> events_;
  ReaderPace pace_;
  RunRecording recording_{clock_};
  LiveScale scale_{chain_.mechanics, recording_, chain_.profile, options_.scale_measurements};

  // The reader's own.
  bool resumed_ = false;  // the next frame is the first after a pause
  long run_index_ = 0;
  long last_run_index_ = 0;
  long index_offset_ = 0;
  long next_index_ = 0;
  double time_offset_s_ = 0.0;
  double next_time_s_ = 0.0;

  std::atomic<std::uint64_t> frame_count_{0};
  std::atomic<std::uint64_t> measured_count_{0};
  std::atomic<std::uint64_t> skipped_count_{0};
  std::atomic<std::uint64_t> gap_count_{0};
  std::atomic<double> newest_arrival_s_{0.0};
  LiveClock source_clock_{info_.live};

  mutable std::mutex fault_mutex_;
  std::optional<std::string> fault_;
  std::exception_ptr recording_fault_;  // on closing it

  // Threads last: they stop before what they use goes away.
  const std::function<void(const Scene&, const StepFailure&)> failed_ =
      [this](const Scene& scene, const StepFailure& failure) { keep_failed(scene, failure); };
  Stage<TrackingStep, SceneExchange> track_stage_{chain_.tracking, to_track_, into(to_force_), clock_, failed_};
  Stage<MechanicsStep, SceneExchange> force_stage_{
      chain_.mechanics, to_force_, [this](MeasuredScene measured) { pass_on(std::move(measured)); }, clock_, failed_};
  Stage<SurfaceStep, Ring<MeasuredScene>> surface_stage_{chain_.surface, to_surface_,
                                                         [this](Scene scene) { publish(std::move(scene)); }, clock_};
  std::jthread reader_;
};

LiveRun::LiveRun(std::unique_ptr<FrameSource> source, PipelineOptions options, double speed_ratio)
    : impl_(std::make_unique<Impl>(std::move(source), std::move(options), speed_ratio)) {}
LiveRun::~LiveRun() = default;

void LiveRun::set_contact_sink(std::function<void(const ContactModel&)> sink) {
  impl_->contact_sink_ = std::move(sink);
}
const Clock& LiveRun::clock() const noexcept {
  return impl_->clock_;
}

double LiveRun::session_lag_s() const noexcept {
  const double lag_s = impl_->source_clock_.lag_s();
  return std::isfinite(lag_s) ? lag_s : 0.0;
}

void LiveRun::start() {
  impl_->start();
}
void LiveRun::stop() {
  impl_->stop();
}
void LiveRun::rethrow_recording_fault() const {
  if (impl_->recording_fault_) std::rethrow_exception(impl_->recording_fault_);
}

void LiveRun::set_paused(bool paused) {
  impl_->pace_.set_paused(paused);
}
bool LiveRun::paused() const noexcept {
  return impl_->pace_.paused();
}

bool LiveRun::restart() {
  if (!impl_->can_restart_) return false;
  impl_->pace_.ask_restart();
  return true;
}

bool LiveRun::can_restart() const noexcept {
  return impl_->can_restart_;
}

const CellProfile& LiveRun::profile() const noexcept {
  return impl_->chain_.profile;
}

const SourceInfo& LiveRun::source_info() const noexcept {
  return impl_->info_;
}
std::shared_ptr<SharedLatest<Scene>> LiveRun::scenes() const noexcept {
  return impl_->scenes_;
}
std::shared_ptr<SharedLatest<Scene>> LiveRun::frames() const noexcept {
  return impl_->frames_;
}
std::vector<Measurement> LiveRun::measurements_since(std::size_t first) const {
  return impl_->rows_.since(first);
}
std::vector<Event> LiveRun::events_since(std::size_t first) const {
  return impl_->events_.since(first);
}
void LiveRun::start_recording(const std::filesystem::path& folder) {
  impl_->start_recording(folder);
}
void LiveRun::stop_recording() {
  impl_->stop_recording();
}
bool LiveRun::record_hand(const Frozen<vtkPolyData>& block, double time_s) {
  return impl_->recording_.hand(block, time_s);
}
void LiveRun::add_scale_measurement(const ScaleMeasurement& measurement) {
  impl_->add_event(impl_->scale_.add(measurement, impl_->newest_time_s()));
}
void LiveRun::forget_scale() {
  impl_->add_event(impl_->scale_.forget(impl_->newest_time_s()));
}
void LiveRun::add_hint(const PersonHint& hint) {
  impl_->chain_.tracking.add_hint(hint);
}
ManipulatorTrack& LiveRun::manipulator() noexcept {
  return impl_->manipulator_;
}
void LiveRun::set_plan(const std::string& plan_json) {
  impl_->recording_.set_plan(plan_json);
}
void LiveRun::add_event(const Event& event) {
  impl_->add_event(event);
}
bool LiveRun::note(const std::string& text) {
  return impl_->note(text);
}
LiveStatus LiveRun::status() const {
  return impl_->status();
}

}  // namespace pellucida
