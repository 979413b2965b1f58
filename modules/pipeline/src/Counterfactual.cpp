#include "pellucida/pipeline/Counterfactual.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <semaphore>
#include <thread>

#include "RecordedFrames.h"
#include "VariantRun.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Ring.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "pellucida/session/Sha256.h"

namespace pellucida {
namespace {

using SharedFrame = std::shared_ptr<const RecordedFrame>;
using WorkSlots = std::counting_semaphore<>;

constexpr std::size_t kWaitingFrameCount = 16;  // for each variant

/// A variant on a thread of its own: takes frames one after another as they come.
class VariantThread {
 public:
  VariantThread(std::unique_ptr<VariantRun> run, const SessionReader& session, WorkSlots& slots)
      : run_(std::move(run)), session_(session), slots_(slots) {
    thread_ = std::jthread([this] { work(); });
  }
  ~VariantThread() { frames_.close(); }
  VariantThread(const VariantThread&) = delete;
  VariantThread& operator=(const VariantThread&) = delete;

  /// Waits for room; false when the variant has failed.
  bool give(const SharedFrame& frame) { return frames_.push_wait(frame); }

  void end() { frames_.close(); }

  /// To be called after `end` or `abandon`; nothing for a variant abandoned. Throws what ended the work.
  std::optional<VariantResult> result() {
    if (thread_.joinable()) thread_.join();
    if (fault_) std::rethrow_exception(fault_);
    return std::move(result_);
  }

  /// Ends without a result: the session stays marked as interrupted.
  void abandon() {
    abandoned_ = true;
    frames_.close();
  }

 private:
  void work() {
    try {
      while (const auto frame = frames_.wait({})) {
        if (abandoned_) return;
        slots_.acquire();
        const SlotReturn back{slots_};
        run_->take(**frame);
      }
      if (abandoned_) return;
      slots_.acquire();
      const SlotReturn back{slots_};
      result_ = run_->finish(session_);
    } catch (...) {
      fault_ = std::current_exception();
      frames_.close();
    }
  }

  struct SlotReturn {
    WorkSlots& slots;
    ~SlotReturn() { slots.release(); }
  };

  std::unique_ptr<VariantRun> run_;
  const SessionReader& session_;
  WorkSlots& slots_;
  Ring<SharedFrame> frames_{kWaitingFrameCount};
  std::atomic<bool> abandoned_{false};
  std::optional<VariantResult> result_;
  std::exception_ptr fault_;
  std::jthread thread_;
};

/// The recorded profile's own mechanics, where variants of its modulus can use the shapes it finds.
class SharedShapes {
 public:
  SharedShapes(const CounterfactualOptions& options, const std::vector<ReplayVariant>& variants) {
    const CellProfile recorded = profile_of(options.pipeline);
    // Even for one: what a variant gives does not depend on those beside it.
    const bool is_wanted = std::any_of(variants.begin(), variants.end(), [&](const ReplayVariant& variant) {
      return has_same_shape(variant.profile, recorded) && to_json(variant.profile) != to_json(recorded);
    });
    if (!is_wanted) return;
    mechanics_.emplace(recorded);
    mechanics_->set_scale_measurements(options.pipeline.scale_measurements);
  }

  void add_to(RecordedFrame& frame) {
    if (!mechanics_ || frame.scene.use < FrameUse::kMeasure || !frame.scene.observation) return;
    if (mechanics_->process(frame.scene)) frame.shape = mechanics_->solved_shape();
  }

 private:
  std::optional<MechanicsStep> mechanics_;
};

void require_possible(const CounterfactualOptions& options, const std::vector<ReplayVariant>& variants) {
  if (variants.empty()) throw UsageError("a replay needs a variant, if only the recording's own");
  if (options.job_count < 1) {
    throw UsageError("--jobs " + std::to_string(options.job_count) + ": give a number of 1 or more");
  }
  if (options.playback.backwards || options.playback.loop_count != 1) {
    throw UsageError(
        "a force depends on what came before: what is measured again runs forwards, once; leave out "
        "--backwards and --loop");
  }
}

}  // namespace

CounterfactualResult run_counterfactual(const std::filesystem::path& session, const CounterfactualOptions& options,
                                        const std::vector<ReplayVariant>& variants) {
  require_possible(options, variants);
  const SteadyClock clock;
  const SessionReader reader(session);
  RecordedFrames frames(reader, options);
  const std::string hash = sha256_of_file(session / "session.json");

  SharedShapes shapes(options, variants);
  WorkSlots slots(options.job_count);
  std::vector<std::unique_ptr<VariantThread>> threads;
  for (const ReplayVariant& variant : variants) {
    threads.push_back(std::make_unique<VariantThread>(
        std::make_unique<VariantRun>(variant, options, reader, hash, clock), reader, slots));
  }
  const auto abandon_all = [&] {
    for (const auto& thread : threads) thread->abandon();
  };
  try {
    long done = 0;
    bool going_on = true;
    while (going_on && !(options.stopped && options.stopped())) {
      auto frame = frames.next();
      if (!frame) break;
      shapes.add_to(*frame);
      const auto shared = std::make_shared<const RecordedFrame>(std::move(*frame));
      going_on = std::all_of(threads.begin(), threads.end(), [&](const auto& thread) { return thread->give(shared); });
      if (options.progress) options.progress(++done, frames.expected_count());
    }
    if (!going_on) abandon_all();
  } catch (...) {
    abandon_all();
    throw;
  }
  for (const auto& thread : threads) thread->end();

  CounterfactualResult result;
  std::exception_ptr fault;
  for (const auto& thread : threads) {
    try {
      if (auto variant = thread->result()) result.variants.push_back(std::move(*variant));
    } catch (...) {
      if (!fault) fault = std::current_exception();
    }
  }
  if (fault) std::rethrow_exception(fault);
  result.absent_count = frames.absent_count();
  result.first_absence = frames.first_absence();
  result.frames_before_recording = frames_before_recording(reader.info());
  result.elapsed_s = clock.now_s();
  return result;
}

}  // namespace pellucida
