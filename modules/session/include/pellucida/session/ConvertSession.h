#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "pellucida/session/SessionCheck.h"

namespace pellucida {

/// Result of a conversion.
struct ConvertReport {
  SessionCounts before;            ///< as the session's head states them
  SessionCounts after;             ///< as written
  std::vector<std::string> notes;  ///< what could not be taken along, and why; a line each
};

/// Writes a session of any version once more, to a new folder and as this version writes: packed and narrowed
/// (SessionLayout::kCompact). Rows, events, images, contours, tools and the recording of the hand are the same to the
/// bit; the surfaces are as narrow as `narrowed_surface` makes them. The start, the provenance and whether the
/// recording was cut off stay as stated; the tables of a replay go along. What can't be read is left out and named.
/// `session` isn't changed.
///
/// Throws InputError when `session` can't be read, or was cut off and not repaired; UsageError when `output` holds a
/// session; OutputError when the disk refuses.
ConvertReport convert_session(const std::filesystem::path& session, const std::filesystem::path& output,
                              const SessionProgress& progress = {});

}  // namespace pellucida
