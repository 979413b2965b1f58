#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "pellucida/session/SessionReader.h"

namespace pellucida {

/// A recorded session in one line each.
struct RecentSession {
  std::filesystem::path folder;
  std::string date;      ///< "2026-11-20 20:15 UTC"; the folder's name where the session states none
  std::string duration;  ///< "12.40 s"
};

/// The folders in `folder` that hold a session, the newest first, at most `count`. By the time of their `session.json`;
/// opens none. A folder that can't be read holds none.
std::vector<std::filesystem::path> newest_sessions(const std::filesystem::path& folder, std::size_t count);

/// Date and duration of an opened session.
RecentSession recent_session(const SessionReader& reader);

/// The picture that a run without a display left in a session's folder; empty when there is none.
std::filesystem::path picture_in(const std::filesystem::path& session);

}  // namespace pellucida
