#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "SessionIndex.h"
#include "SessionJson.h"
#include "pellucida/session/SessionCheck.h"

namespace pellucida {

/// Everything a check learnt about a session.
struct SessionFindings {
  SessionHead head;
  bool head_readable = false;
  SessionTable<Measurement> measurements;
  SessionTable<Event> events;
  SessionTable<FileChecksum> checksums;
  SessionFiles files;
  std::vector<std::string> unreadable;  ///< data files that can't be read, or are not what their checksum or stamp says
  bool pvd_right = false;
  bool empty_right = true;
  double pixel_size_um = 0.0;  ///< of the first image that could be read; 0 for none
};

/// Mends what a check found (see `check_session`) and notes each thing done in `report.repairs`. Throws OutputError.
void repair_session(const std::filesystem::path& folder, const SessionFindings& findings, SessionReport& report);

}  // namespace pellucida
