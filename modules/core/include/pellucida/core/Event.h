#pragma once
#include <string>

namespace pellucida {

/// Something that happened in a session: a row of `events.csv` (`time_s,kind,detail`).
/// Kinds: contact, release, puncture, lost, found, dropped, gap, limit, note, started, stopped.
struct Event {
  double time_s = 0.0;
  std::string kind;
  std::string detail;
};

}  // namespace pellucida
