#pragma once
#include <map>
#include <string>
#include <vector>

#include "pellucida/mechanics/ScaleMeasurement.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/pipeline/PipelineOptions.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// Where the numbers of a session come from, beside what its writer knows (docs/file-format.md, Provenance).
struct RunProvenance {
  std::map<std::string, std::string> input_sha256;  ///< by what was read: `file`, `session_json`, ...
  long frames_before_recording = 0;  ///< frames the run had seen when the recording began: its steps remember them
  std::string replay_json;           ///< of a replay: what was replayed, what was changed; an object; empty for none
};

/// As `SessionInfo::provenance_json`: with the versions and parameters in `options`, and the profile's hash.
std::string to_json(const RunProvenance& provenance, const PipelineOptions& options, const CellProfile& profile);

/// The profile that `options` name or hold. Throws as `load_profile`.
CellProfile profile_of(const PipelineOptions& options);

/// How cells of `profile` are tracked: as `options` say, and of its size.
TrackerOptions tracker_of(const PipelineOptions& options, const CellProfile& profile);

/// The options a session was measured with: its own profile, tracking, mesh and measurements of the scale. What an
/// earlier version's session does not state keeps its default. Throws InputError for a damaged entry; the text names
/// it.
PipelineOptions recorded_options(const SessionInfo& info);

/// The measurements of this cell's scale and what came of them, as `SessionInfo::palpation_json`.
std::string palpation_json(const std::vector<ScaleMeasurement>& measurements, const CellScale& scale,
                           const std::vector<PunctureRisk>& risk);

/// How many frames the recorded run had seen before the recording; 0 where the session does not say.
long frames_before_recording(const SessionInfo& info);

}  // namespace pellucida
