#include "commands/GuidedSession.h"

#include <cstdio>

#include "commands/MeasureSession.h"
#include "pellucida/operation/HapticWriter.h"
#include "pellucida/operation/ProfileStrength.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {

GuidedResult measure_guided_session(const SimulatedInjectionOptions& operated, const PipelineOptions& pipeline,
                                    const std::filesystem::path& folder, const SessionOptions& session_options,
                                    const std::string& command_line) {
  SimulatedInjectionOptions of_profile = operated;
  of_profile.cell = strength_of(profile_of(pipeline));
  SimulatedInjectionSource microscope(of_profile);
  SessionWriter* session = nullptr;
  HapticWriter hand([&](const Event& event) { session->event(event); },
                    [&](const Frozen<vtkPolyData>& paths, double time_s) {
                      session->write_hand(paths, time_s);
                      return true;
                    });
  bool planned = false;
  const auto take_ticks = [&](SessionWriter& writer) {
    session = &writer;
    for (const LimitEvent& limit : microscope.take_events()) hand.add(limit);
    for (const HapticRecord& tick : microscope.take_records()) hand.add(tick);
  };
  SessionAddition addition;
  addition.after_frame = [&](SessionWriter& writer, const Scene& scene) {
    microscope.see(scene);
    if (!planned && microscope.plan()) writer.set_plan(to_json(*microscope.plan()));
    planned = microscope.plan().has_value();
    take_ticks(writer);
    hand.flush(scene.measurement.time_s, 0.0);
  };
  addition.at_end = [&](SessionWriter& writer) {
    take_ticks(writer);
    hand.finish(0.0);
  };
  GuidedResult result;
  // One thread: the hand must know of a frame before the next is exposed.
  result.measured = measure_session(microscope, pipeline, 1, folder, session_options, command_line, addition);
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
