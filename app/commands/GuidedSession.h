#pragma once
#include <filesystem>
#include <string>

#include "pellucida/operation/SimulatedInjectionSource.h"
#include "pellucida/pipeline/BatchRun.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// A guided injection by the simulated operator, and what was measured of it.
struct GuidedResult {
  BatchResult measured;
  InjectionOutcome injection;
};

/// Runs it on the virtual microscope in simulated time, every frame measured, into a session folder with the hand's
/// recording and the plan; the limits of force and depth are those of the pipeline's profile. Throws as
/// `measure_session` and `SimulatedInjectionSource` do.
GuidedResult measure_guided_session(const SimulatedInjectionOptions& operated, const PipelineOptions& pipeline,
                                    const std::filesystem::path& folder, const SessionOptions& session_options,
                                    const std::string& command_line);

/// Three lines on how the injection went; says that the operator is simulated.
std::string summary(const InjectionOutcome& outcome);

}  // namespace pellucida
