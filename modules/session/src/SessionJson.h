#pragma once
#include <filesystem>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// Everything in `session.json`.
struct SessionHead {
  SessionInfo info;
  SessionOptions options;
  SessionCounts counts;
  std::string created;     ///< wall clock at the start, UTC, ISO 8601
  bool complete = false;   ///< closed by the writer
  bool recovered = false;  ///< mended after a crash by `check --repair`
  bool checked = false;    ///< read: it carries a checksum
  bool changed = false;    ///< read: by somebody else, its checksum is not that of its text
};

/// A session that a later version wrote: nothing is wrong with it, and this version must not change it.
class LaterSchemaError : public InputError {
 public:
  using InputError::InputError;
};

/// The text of `session.json`. Throws UsageError when `info.profile_json` isn't JSON.
std::string to_json(const SessionHead& head);

/// The inverse; keys not there keep their defaults, keys unknown are ignored. Throws InputError naming the file when it
/// isn't JSON or not the head of a session, is of a later schema version, or holds a value of a wrong type or an
/// impossible one.
SessionHead read_session_json(const std::filesystem::path& file);

/// The text of `session.json` after a repair: as it was, later versions' keys too, with these counts, marked as
/// recovered, its checksum made anew. Throws InputError as above.
std::string repaired_json(const std::filesystem::path& file, const SessionCounts& counts);

}  // namespace pellucida
