#pragma once
#include <memory>
#include <string>

#include "RecordedFrames.h"
#include "pellucida/core/Clock.h"
#include "pellucida/mechanics_vtk/MechanicsStep.h"
#include "pellucida/mechanics_vtk/NodalForces.h"
#include "pellucida/pipeline/Counterfactual.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {

/// True when two profiles give the same shape at every depth: they differ in their modulus, and what follows from it,
/// alone.
bool has_same_shape(const CellProfile& one, const CellProfile& other);

/// One variant at work: the mechanics under its profile, the differences, its session. One thread at a time.
class VariantRun {
 public:
  /// Creates the session. `session_json_sha256`: of what is replayed.
  VariantRun(const ReplayVariant& variant, const CounterfactualOptions& options, const SessionReader& session,
             const std::string& session_json_sha256, const Clock& clock);

  void take(const RecordedFrame& frame);
  /// Writes the table of differences and the recording's own events, and closes the session.
  VariantResult finish(const SessionReader& session);

 private:
  const ReplayVariant& variant_;
  const CounterfactualOptions& options_;
  const Clock& clock_;
  MechanicsStep mechanics_;
  NodalForces nodal_forces_;
  const bool has_recorded_shape_;
  SessionWriter writer_;
  ChangeLog log_;
  double last_time_s_ = 0.0;
};

}  // namespace pellucida
