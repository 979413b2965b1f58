#pragma once
#include <optional>
#include <string>

#include "pellucida/ui/WindowOptions.h"

namespace pellucida {

/// Options of the window in Review mode.
struct ReviewOptions : WindowOptions {
  std::string compare;           ///< folder of a session to compare with; empty: none
  std::optional<double> from_s;  ///< time shown first; nothing: the session's beginning
  double speed_ratio = 1.0;      ///< 0.1 .. 10 times the session's own; the nearest of these
  bool loop = false;
  bool backwards = false;
};

/// Opens the window in Review mode on the session in folder `session` (complete or not; empty: the window asks for
/// one), and returns the event loop's exit status, or `kToStartPage`, when it is closed. A session that can't be read
/// is an error in the window, which stays open. Needs an X server; main thread only. Throws DeviceError when no window
/// can be opened, OutputError when the screenshot can't be written.
int run_review(const std::string& session, const ReviewOptions& options);

}  // namespace pellucida
