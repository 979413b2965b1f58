#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// Result of a check.
struct SessionReport {
  SessionCounts counts;               ///< what is actually present
  std::vector<std::string> problems;  ///< damage, one line each
  std::vector<std::string> repairs;   ///< what was done about it, one line each
  std::vector<std::string> notes;     ///< remarks, not damage
  std::size_t problem_count = 0;      ///< all problems, also those beyond the lines kept in `problems`
  bool repaired = false;              ///< the damage was repaired: a further check finds none

  bool fine() const noexcept { return problem_count == 0 || repaired; }
};

/// Called from time to time with (files read, all files).
using SessionProgress = std::function<void(std::size_t, std::size_t)>;

/// Verifies a session: `session.json` reads and its counts are right, every row of both tables is complete, every data
/// file reads and carries the stamp its name states, `session.pvd` lists exactly what is present.
///
/// With `repair`: rows that are torn are moved to `damaged/lines.txt`, data files that can't be read are moved to
/// `damaged/`, left-over temporary files are removed, and `session.pvd` and the counts of `session.json` are rebuilt.
/// No data file is ever deleted. A session that is still being written must not be repaired.
///
/// Throws InputError when there is no session at all, or its `session.json` cannot be read and nothing else is present
/// to rebuild it from; OutputError when a repair can't be written.
SessionReport check_session(const std::filesystem::path& folder, bool repair, const SessionProgress& progress = {});

}  // namespace pellucida
