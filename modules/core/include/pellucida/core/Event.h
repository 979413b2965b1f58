#pragma once
#include <string>

namespace pellucida {

/// An event of a session: a row of `events.csv` (`time_s,kind,detail`). Kinds: contact, release, puncture, lost, found,
/// dropped, gap, limit, note, warning, palpation, started, stopped.
struct Event {
  double time_s = 0.0;
  std::string kind;
  std::string detail;
};

}  // namespace pellucida
