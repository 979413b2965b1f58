#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// How `session.pvd` differs from what the rows and files make of it.
struct PvdDifference {
  bool readable = true;
  std::size_t missing_count = 0;  ///< data files that it doesn't list, or not at their time
  std::string first_missing;
  std::size_t extra_count = 0;  ///< data files listed that are not there at that time, or listed twice
  std::string first_extra;

  bool none() const noexcept { return readable && missing_count == 0 && extra_count == 0; }
};

/// Compares the list with the steps; byte for byte first, entry for entry where it is not the same. Throws InputError
/// for a file that can't be read.
PvdDifference compare_pvd(const std::filesystem::path& file, const std::vector<SessionStep>& steps, bool frames);

}  // namespace pellucida
