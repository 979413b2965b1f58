#pragma once
#include <filesystem>
#include <string>

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
};

/// The text of `session.json`. Throws UsageError when `info.profile_json` isn't JSON.
std::string to_json(const SessionHead& head);

/// The inverse; keys not there keep their defaults, keys unknown are ignored.
/// Throws InputError naming the file when it isn't JSON, or holds a value of a wrong type.
SessionHead read_session_json(const std::filesystem::path& file);

}  // namespace pellucida
