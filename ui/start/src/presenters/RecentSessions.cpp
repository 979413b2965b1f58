#include "presenters/RecentSessions.h"

#include <algorithm>

#include "pellucida/session/SessionSource.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

struct DatedFolder {
  fs::path folder;
  fs::file_time_type written;
};

}  // namespace

std::vector<fs::path> newest_sessions(const fs::path& folder, std::size_t count) {
  std::vector<DatedFolder> found;
  std::error_code status;
  for (auto entry = fs::directory_iterator(folder, status); !status && entry != fs::directory_iterator();
       entry.increment(status)) {
    if (!is_session(entry->path())) continue;
    std::error_code gone;
    const auto written = fs::last_write_time(entry->path() / "session.json", gone);
    if (!gone) found.push_back({entry->path(), written});
  }
  std::sort(found.begin(), found.end(), [](const DatedFolder& a, const DatedFolder& b) {
    return a.written != b.written ? a.written > b.written : a.folder > b.folder;
  });
  if (found.size() > count) found.resize(count);
  std::vector<fs::path> folders;
  for (auto& session : found) folders.push_back(std::move(session.folder));
  return folders;
}

RecentSession recent_session(const SessionReader& reader) {
  // "2026-11-20T20:15:00Z" to the minute.
  std::string date = reader.created().substr(0, 16);
  std::replace(date.begin(), date.end(), 'T', ' ');
  date = date.empty() ? reader.folder().filename().string() : date + " UTC";
  const auto& steps = reader.steps();
  const double duration_s = steps.empty() ? 0.0 : std::max(0.0, steps.back().time_s - steps.front().time_s);
  return {reader.folder(), date, readout::time(duration_s)};
}

fs::path picture_in(const fs::path& session) {
  std::error_code ignored;
  const fs::path picture = session / "picture.png";
  return fs::is_regular_file(picture, ignored) ? picture : fs::path();
}

}  // namespace pellucida
