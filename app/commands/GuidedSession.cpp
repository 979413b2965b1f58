#include "commands/GuidedSession.h"

#include <cstdio>

#include "commands/MeasureSession.h"
#include "pellucida/operation/HapticPathBlock.h"
#include "pellucida/operation/ProfileStrength.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {
namespace {

constexpr std::size_t kBlockTicks = 1000;

// Carries plan, hand and limits into the session while it is written.
class HandWriter {
 public:
  explicit HandWriter(SimulatedInjectionSource& microscope) : microscope_(microscope) {}

  void add(SessionWriter& writer) {
    if (!planned_ && microscope_.plan()) {
      writer.set_plan(to_json(*microscope_.plan()));
      planned_ = true;
    }
    for (const Event& event : microscope_.take_events()) writer.event(event);
    const auto records = microscope_.take_records();
    records_.insert(records_.end(), records.begin(), records.end());
    // What is left at the end is less than a block only when the operator is done.
    if (records_.size() >= kBlockTicks || (!records_.empty() && microscope_.outcome().done)) {
      writer.write_hand(make_haptic_path_block(records_, 0.0), records_.front().time_s);
      records_.clear();
    }
  }

 private:
  SimulatedInjectionSource& microscope_;
  std::vector<HapticRecord> records_;
  bool planned_ = false;
};

}  // namespace

GuidedResult measure_guided_session(const SimulatedInjectionOptions& operated, const PipelineOptions& pipeline,
                                    const std::filesystem::path& folder, const SessionOptions& session_options,
                                    const std::string& command_line) {
  SimulatedInjectionOptions of_profile = operated;
  of_profile.cell = strength_of(load_profile(pipeline.profile));
  SimulatedInjectionSource microscope(of_profile);
  HandWriter hand(microscope);
  GuidedResult result;
  // One thread: the hand must know of a frame before the next is exposed.
  result.measured = measure_session(microscope, pipeline, 1, folder, session_options, command_line,
                                    [&](SessionWriter& writer, const Scene& scene) {
                                      microscope.see(scene);
                                      hand.add(writer);
                                    });
  result.injection = microscope.outcome();
  return result;
}

std::string summary(const InjectionOutcome& outcome) {
  char text[512];
  std::string lines;
  if (outcome.puncture_s >= 0.0) {
    std::snprintf(
        text, sizeof text,
        "injection  simulated operator: membrane gave way at %.2f uN, %.1f um (the specimen's truth), %.2f s\n",
        outcome.puncture_force_uN, outcome.puncture_depth_um, outcome.puncture_s);
  } else {
    std::snprintf(text, sizeof text, "injection  simulated operator: the membrane never gave way; deepest %.1f um\n",
                  outcome.puncture_depth_um);
  }
  lines += text;
  std::snprintf(text, sizeof text, "           %.1f pL left in the cell; %s after %.1f s\n", outcome.deposited_pL,
                outcome.done ? "needle taken out" : "given up", outcome.duration_s);
  lines += text;
  std::snprintf(text, sizeof text, "hand       %.2f um RMS from the planned line, at most %.2f N felt\n",
                outcome.lateral_rms_um, outcome.peak_hand_force_N);
  return lines + text;
}

}  // namespace pellucida
