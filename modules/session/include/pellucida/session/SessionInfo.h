#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "pellucida/core/Version.h"
#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/vtk_files/DataWriter.h"

namespace pellucida {

/// Description of a session: the head of `session.json`.
struct SessionInfo {
  std::string software_version = kVersion;
  SourceInfo source;                              ///< origin of the frames, and the calibration with its origin
  std::string profile_name;                       ///< of the cell profile used; empty for none
  std::string profile_json;                       ///< the profile's whole content, JSON text; empty for none
  std::string command_line;                       ///< as the user typed it; empty for the window
  std::map<std::string, std::uint64_t> seeds;     ///< of everything random, by the name of its user
  std::map<std::string, double> clock_offsets_s;  ///< other clock minus session clock, by the clock's name
  std::string clocks_json;     ///< how the clocks of a live recording run against each other; empty: unknown
  std::string palpation_json;  ///< an independent measurement of the cell and its result; empty: none
  std::string plan_json;       ///< the plan that guided the hand; empty: none
  /// Where the numbers come from: versions, parameters, hashes of inputs, and of a replay what it replays; a JSON
  /// object. The writer adds `frames_used` and `frames_sha256`. Empty: unknown.
  std::string provenance_json;
  std::string drop_policy = "none";  ///< which frames may be lost on the way to the recorder, in words
};

/// How the data files are made. All are VTK XML files of the same names and arrays, which every version reads.
enum class SessionLayout {
  kCompact,  ///< packed by `DataWriter`, surfaces as narrow as `narrowed_surface` makes them
  kWide      ///< as before there was another: by VTK's own writers, surfaces as they come from the model
};

/// Of a session that is written once more.
struct RewrittenSession {
  std::string created;   ///< wall clock at the start of the recording, UTC
  bool cut_off = false;  ///< the recording was: once closed, the session counts as recovered, not as complete
};

/// When what was written is asked onto the disk.
enum class SessionSync {
  kAlways,  ///< each half second: a power cut loses at most the last second
  kAtEnd    ///< on closing: for what can be computed again
};

/// Options of writing.
struct SessionOptions {
  bool frames = true;  ///< keep the images themselves
  SessionLayout layout = SessionLayout::kCompact;
  SessionSync sync = SessionSync::kAlways;
  /// What is written was recorded before. Its provenance is whole: the writer adds nothing to it.
  std::optional<RewrittenSession> rewritten;
};

/// What one step cost to write.
struct WriteCost {
  double packing_s = 0.0;  ///< on the processor
  double disk_s = 0.0;     ///< waiting for the system to take it
};

/// The parts of a step that have a file of their own; the numbers are those of the attribute `part` in `session.pvd`.
enum class SessionPart : int { kSurface = 0, kMembranes = 1, kTools = 2, kFrame = 3 };
inline constexpr std::size_t kSessionPartCount = 4;

/// Amounts of data.
struct SessionCounts {
  std::uint64_t step_count = 0;                               ///< rows of `measurements.csv`
  std::array<std::uint64_t, kSessionPartCount> file_count{};  ///< data files, by SessionPart
  std::uint64_t hand_block_count = 0;                         ///< files of the recording of the hand
  std::uint64_t unmeasured_count = 0;                         ///< of these steps, kept without numbers
  std::uint64_t event_count = 0;                              ///< rows of `events.csv`
  std::uint64_t dropped_count = 0;  ///< frames without their image for want of time (events `dropped`)
  std::uint64_t thinned_count = 0;  ///< frames without their surface for want of time (events `thinned`)
  std::uint64_t byte_count = 0;     ///< of data files and rows

  std::uint64_t files(SessionPart part) const noexcept { return file_count[static_cast<std::size_t>(part)]; }
};

/// One frame of a session: its time, and which of its parts are on the disk.
struct SessionStep {
  long frame_index = 0;
  double time_s = 0.0;
  std::array<bool, kSessionPartCount> present{};  ///< by SessionPart

  bool has(SessionPart part) const noexcept { return present[static_cast<std::size_t>(part)]; }
};

}  // namespace pellucida
