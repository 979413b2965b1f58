#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// What a check found.
struct SessionReport {
  SessionCounts counts;               ///< what is really there
  std::vector<std::string> problems;  ///< damage, a line each
  std::vector<std::string> repairs;   ///< what was done about it, a line each
  std::vector<std::string> notes;     ///< worth knowing, but no damage
  std::size_t problem_count = 0;      ///< all problems, also those beyond the lines kept in `problems`
  bool repaired = false;              ///< the damage was mended: a further check finds none

  bool fine() const noexcept { return problem_count == 0 || repaired; }
};

/// Called now and then with (files read, files in all).
using SessionProgress = std::function<void(std::size_t, std::size_t)>;

/// Verifies a session: `session.json` reads and counts rightly, every row of both tables is whole, every data file
/// reads and carries the stamp its name says, `session.pvd` lists exactly what is there.
///
/// With `repair`: rows that are torn are moved to `damaged/lines.txt`, data files that can't be read are moved to
/// `damaged/`, left-over temporary files are removed, and `session.pvd` and the counts of `session.json` are made anew.
/// No data file is ever deleted. Don't repair a session that is still being written.
///
/// Throws InputError when there is no session at all, or its `session.json` is beyond reading and nothing else is there
/// to build it from; OutputError when a repair can't be written.
SessionReport check_session(const std::filesystem::path& folder, bool repair, const SessionProgress& progress = {});

}  // namespace pellucida
