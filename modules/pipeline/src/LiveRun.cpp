#include "pellucida/pipeline/LiveRun.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>

#include "Chain.h"
#include "Recorder.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Stage.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

using SceneExchange = SharedLatest<Scene>;

// Rows and events so far, for charts and logs that miss nothing.
template <class T>
class Log {
 public:
  void append(const T& item) {
    std::lock_guard lock(mutex_);
    items_.push_back(item);
  }
  std::vector<T> since(std::size_t first) const {
    std::lock_guard lock(mutex_);
    if (first >= items_.size()) return {};
    return {items_.begin() + static_cast<std::ptrdiff_t>(first), items_.end()};
  }
  std::size_t size() const {
    std::lock_guard lock(mutex_);
    return items_.size();
  }

 private:
  mutable std::mutex mutex_;
  std::vector<T> items_;
};

}  // namespace

class LiveRun::Impl {
 public:
  Impl(std::unique_ptr<FrameSource> source, PipelineOptions options)
      : source_(std::move(source)), info_(source_->info()), can_restart_(source_->restart()), chain_(options) {}

  ~Impl() { stop(); }

  void start() {
    force_stage_.start();
    surface_stage_.start();
    track_stage_.start();
    reader_ = std::jthread([this](std::stop_token stop) { read(stop); });
  }

  void stop() {
    reader_.request_stop();
    wake_.notify_all();
    if (reader_.joinable()) reader_.join();
    track_stage_.stop();
    surface_stage_.stop();
    force_stage_.stop();
    try {
      stop_recording();
    } catch (const std::exception& error) {
      set_fault(error.what());
    }
  }

  // The reader: takes frames at their time and starts them on their way.
  void read(std::stop_token stop) {
    try {
      while (!stop.stop_requested()) {
        if (restart_wanted_.exchange(false)) begin_anew();
        if (paused_ || ended_) {
          rest(stop);
          continue;
        }
        auto frame = source_->next();
        if (!frame) {
          ended_ = true;
          continue;
        }
        if (!info_.live) wait_for(*frame, stop);
        if (stop.stop_requested()) return;
        hand_out(*frame);
      }
    } catch (const std::exception& error) {
      set_fault(error.what());
      ended_ = true;
    }
  }

  void begin_anew() {
    source_->restart();
    ++run_index_;
    index_offset_ = next_index_;
    time_offset_s_ = next_time_s_;
    first_due_s_.reset();
    session_lag_s_ = kNoLag_s;
    ended_ = false;
  }

  // Sleeps until something is asked of the reader.
  void rest(std::stop_token stop) {
    std::unique_lock lock(wake_mutex_);
    wake_.wait_for(lock, stop, std::chrono::milliseconds(200),
                   [&] { return restart_wanted_ || (!paused_ && !ended_); });
    first_due_s_.reset();
  }

  // Sleeps until the frame's own time has come; the pace begins anew after a pause.
  void wait_for(const Frame& frame, std::stop_token stop) {
    if (!first_due_s_) first_due_s_ = clock_.now_s() - frame.time_s;
    const double wait_s = *first_due_s_ + frame.time_s - clock_.now_s();
    if (wait_s <= 0.0) return;
    std::unique_lock lock(wake_mutex_);
    wake_.wait_for(lock, stop, std::chrono::duration<double>(wait_s), [] { return false; });
  }

  void hand_out(Frame frame) {
    if (run_index_ > 0) number_on(frame);
    next_index_ = frame.frame_index + 1;
    next_time_s_ = frame.time_s + 1.0 / info_.frame_rate_hz;
    const Scene scene = scene_of(frame, clock_.now_s(), run_index_);
    session_lag_s_ = std::min(session_lag_s_.load(), scene.arrival_s - frame.time_s);
    ++frame_count_;
    gap_count_ += static_cast<std::uint64_t>(frame.gap_count);
    with_recorder([&](Recorder& recorder) { recorder.announce(scene); });
    frames_->publish(scene);
    if (auto skipped = to_track_.publish(scene)) skip(*skipped);
  }

  // After a restart numbers and times go on from where they were, in the image's stamp too.
  void number_on(Frame& frame) const {
    frame.frame_index += index_offset_;
    frame.time_s += time_offset_s_;
    auto image = frame.image.shallow_copy();
    stamp(image, frame.time_s, frame.frame_index);
    frame.image = Frozen<vtkImageData>(image);
  }

  // A step had nothing to say of this frame: it is kept with the reason.
  void keep_failed(const Scene& scene, const StepFailure& failure) {
    Scene failed = scene;
    failed.events.push_back({scene.measurement.time_s, "lost", failure.reason});
    publish(std::move(failed));
  }

  // A newer frame came first: this one is kept, not measured.
  void skip(const Scene& scene) {
    ++skipped_count_;
    with_recorder([&](Recorder& recorder) { recorder.settle(unmeasured(scene)); });
  }

  // The end of the chain: what everybody else sees.
  void publish(Scene scene) {
    if (contact_sink_) contact_sink_(scene.contact);
    stamp_age(scene, clock_);
    newest_arrival_s_ = scene.arrival_s;
    rows_.append(scene.measurement);
    for (const Event& event : scene.events) events_.append(event);
    with_recorder([&](Recorder& recorder) { recorder.settle(scene); });
    scenes_->publish(std::move(scene));
    ++measured_count_;  // last: who sees the count finds the scene
  }

  template <class Use>
  void with_recorder(Use use) {
    std::lock_guard lock(recorder_mutex_);
    if (recorder_) use(*recorder_);
  }

  void start_recording(const std::filesystem::path& folder) {
    SessionInfo info;
    info.source = info_;
    info.plan_json = plan();
    info.profile_name = chain_.profile.name;
    info.profile_json = to_json(chain_.profile);
    info.drop_policy =
        "live: a frame that a newer one overtakes is recorded but not measured (event dropped); a frame the disk has "
        "no "
        "time for is lost (event dropped)";
    {
      std::lock_guard lock(recorder_mutex_);
      if (recorder_) throw UsageError("a recording is running already; stop it first");
    }
    auto recorder = std::make_unique<Recorder>(folder, info, clock_);
    std::lock_guard lock(recorder_mutex_);
    recorder_ = std::move(recorder);
    recording_folder_ = folder.string();
    recorder_->event({newest_time_s(), "started", "recording of " + info_.name});
  }

  void stop_recording() {
    std::unique_ptr<Recorder> ended;
    {
      std::lock_guard lock(recorder_mutex_);
      ended = std::move(recorder_);
    }
    if (!ended) return;
    ended->event({newest_time_s(), "stopped", "recording"});
    const auto keep_counts = [&] {
      recorded_count_ = ended->written_count();
      recorder_dropped_count_ = ended->dropped_count();
    };
    try {
      ended->close();
    } catch (...) {
      keep_counts();
      throw;
    }
    keep_counts();
  }

  bool record_hand(const Frozen<vtkPolyData>& block, double time_s) {
    std::lock_guard lock(recorder_mutex_);
    return !recorder_ || recorder_->hand(block, time_s);
  }

  void set_plan(const std::string& plan_json) {
    {
      std::lock_guard lock(plan_mutex_);
      plan_json_ = plan_json;
    }
    with_recorder([&](Recorder& recorder) { recorder.plan(plan_json); });
  }

  std::string plan() const {
    std::lock_guard lock(plan_mutex_);
    return plan_json_;
  }

  void note(const std::string& text) { add_event({newest_time_s(), "note", text}); }

  void add_event(const Event& event) {
    events_.append(event);
    with_recorder([&](Recorder& recorder) { recorder.event(event); });
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
    status.reconstruction_ms = 1e3 * surface_stage_.counts().last_step_s;
    status.mechanics_ms = 1e3 * force_stage_.counts().last_step_s;
    status.frame_age_ms = measured_count_ > 0 ? 1e3 * (clock_.now_s() - newest_arrival_s_) : 0.0;
    status.finished = ended_ && measured_count_ + skipped_count_ >= frame_count_;
    {
      std::lock_guard lock(recorder_mutex_);
      status.recording = recorder_ != nullptr;
      status.recording_folder = recording_folder_;
      status.recorded_count = recorder_ ? recorder_->written_count() : recorded_count_;
      status.recorder_dropped_count = recorder_ ? recorder_->dropped_count() : recorder_dropped_count_;
      if (recorder_ && recorder_->fault()) status.fault = recorder_->fault();
    }
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
  Chain chain_;

  const std::shared_ptr<SceneExchange> frames_ = std::make_shared<SceneExchange>();
  const std::shared_ptr<SceneExchange> scenes_ = std::make_shared<SceneExchange>();
  SceneExchange to_track_;
  SceneExchange to_surface_;
  SceneExchange to_force_;
  Log<Measurement> rows_;
  Log<Event> events_;

  // Asked for by the controlling thread, done by the reader.
  std::atomic<bool> paused_{false};
  std::atomic<bool> restart_wanted_{false};
  std::atomic<bool> ended_{false};
  std::mutex wake_mutex_;
  std::condition_variable_any wake_;

  // The reader's own.
  std::optional<double> first_due_s_;
  long run_index_ = 0;
  long index_offset_ = 0;
  long next_index_ = 0;
  double time_offset_s_ = 0.0;
  double next_time_s_ = 0.0;

  std::atomic<std::uint64_t> frame_count_{0};
  std::atomic<std::uint64_t> measured_count_{0};
  std::atomic<std::uint64_t> skipped_count_{0};
  std::atomic<std::uint64_t> gap_count_{0};
  std::atomic<double> newest_arrival_s_{0.0};
  static constexpr double kNoLag_s = std::numeric_limits<double>::infinity();
  std::atomic<double> session_lag_s_{kNoLag_s};  // the clock less the session's time; smallest seen

  mutable std::mutex recorder_mutex_;
  std::unique_ptr<Recorder> recorder_;
  std::string recording_folder_;
  std::uint64_t recorded_count_ = 0;
  std::uint64_t recorder_dropped_count_ = 0;

  mutable std::mutex plan_mutex_;
  std::string plan_json_;

  mutable std::mutex fault_mutex_;
  std::optional<std::string> fault_;

  // Threads last: they stop before what they use goes away.
  const std::function<void(const Scene&, const StepFailure&)> failed_ =
      [this](const Scene& scene, const StepFailure& failure) { keep_failed(scene, failure); };
  Stage<TrackingStep, SceneExchange> track_stage_{chain_.tracking, to_track_, into(to_surface_), clock_, failed_};
  Stage<ReconstructionStep, SceneExchange> surface_stage_{chain_.reconstruction, to_surface_, into(to_force_), clock_,
                                                          failed_};
  Stage<MechanicsStep, SceneExchange> force_stage_{chain_.mechanics, to_force_,
                                                   [this](Scene scene) { publish(std::move(scene)); }, clock_, failed_};
  std::jthread reader_;
};

LiveRun::LiveRun(std::unique_ptr<FrameSource> source, PipelineOptions options)
    : impl_(std::make_unique<Impl>(std::move(source), std::move(options))) {}
LiveRun::~LiveRun() = default;

void LiveRun::set_contact_sink(std::function<void(const ContactModel&)> sink) {
  impl_->contact_sink_ = std::move(sink);
}
const Clock& LiveRun::clock() const noexcept {
  return impl_->clock_;
}

double LiveRun::session_lag_s() const noexcept {
  const double lag_s = impl_->session_lag_s_;
  return std::isfinite(lag_s) ? lag_s : 0.0;
}

void LiveRun::start() {
  impl_->start();
}
void LiveRun::stop() {
  impl_->stop();
}

void LiveRun::set_paused(bool paused) {
  impl_->paused_ = paused;
  impl_->wake_.notify_all();
}
bool LiveRun::paused() const noexcept {
  return impl_->paused_;
}

bool LiveRun::restart() {
  if (!impl_->can_restart_) return false;
  impl_->restart_wanted_ = true;
  impl_->wake_.notify_all();
  return true;
}

bool LiveRun::can_restart() const noexcept {
  return impl_->can_restart_;
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
  return impl_->record_hand(block, time_s);
}
void LiveRun::set_plan(const std::string& plan_json) {
  impl_->set_plan(plan_json);
}
void LiveRun::add_event(const Event& event) {
  impl_->add_event(event);
}
void LiveRun::note(const std::string& text) {
  impl_->note(text);
}
LiveStatus LiveRun::status() const {
  return impl_->status();
}

}  // namespace pellucida
