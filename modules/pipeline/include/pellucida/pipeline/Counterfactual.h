#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/pipeline/ChangeFigures.h"
#include "pellucida/pipeline/PipelineOptions.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/session/SessionSource.h"

namespace pellucida {

/// What runs again.
enum class Rerun {
  kTracking,  ///< everything, from the recorded images
  kMechanics  ///< the forces alone, from the recorded contours and tools
};

/// One replay among several of the same session.
struct ReplayVariant {
  std::string name;              ///< in the table of changes
  CellProfile profile;           ///< that the forces are computed with
  std::string changes_json;      ///< for the record: what is different from the recording, an object; empty: nothing
  std::filesystem::path folder;  ///< of the session to write
};

struct CounterfactualOptions {
  Rerun rerun = Rerun::kTracking;
  PipelineOptions pipeline;  ///< tracking, mesh, measurements of the scale; the profile is the variant's
  PlaybackOptions playback;  ///< `from_s`, `to_s`, `every`, `pixel_size_um`, `all_frames` count
  bool keep_frames = false;  ///< write the images too
  bool tables_only = false;  ///< write rows, events and tables, but no surfaces, contours and tools: in less time
  int job_count = 2;         ///< variants at work at the same time, >= 1
  std::string command_line;
  std::function<void(long done, std::optional<long> all)> progress;  ///< after each frame; may be empty
  /// Asked before each frame and at the end, on several threads; true: the sessions end there, whole. May be empty.
  std::function<bool()> stopped;
};

/// Result of one variant.
struct VariantResult {
  std::string name;
  std::filesystem::path folder;
  CellProfile profile;
  ChangeFigures changes;
};

struct CounterfactualResult {
  std::vector<VariantResult> variants;  ///< in the order given
  long absent_count = 0;                ///< frames whose evidence was not recorded, or can't be read: without numbers
  std::string first_absence;            ///< why the first of them
  long frames_before_recording = 0;     ///< > 0: the recorded run knew frames that the replay does not
  double elapsed_s = 0.0;
};

/// True when a session holds, with 64 bit, all that the forces are computed from (sessions of earlier versions don't).
bool has_observations(const SessionReader& session);

/// Measures a recorded session again, once for each variant, into a session each: the steps, and with the same inputs
/// the bits, are those of the recorded run; frames it had no time for stay without numbers (`Frame::use`). Tracking and
/// reconstruction run once for all variants. Each new session holds the recorded fields and the differences beside its
/// own (docs/file-format.md, A replayed session), `differences.csv`, and the events of the recording that no
/// measurement can repeat. The recorded hints of a person count again where they did, with those in
/// `pipeline.hints` among them, in the order of time; frames before the first new one keep their bits.
///
/// Throws UsageError for new hints where only the mechanics run; InputError when the session lacks what `rerun` needs,
/// UsageError for options out of range or a folder that holds a session, OutputError when the disk refuses.
CounterfactualResult run_counterfactual(const std::filesystem::path& session, const CounterfactualOptions& options,
                                        const std::vector<ReplayVariant>& variants);

}  // namespace pellucida
