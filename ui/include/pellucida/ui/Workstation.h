#pragma once
#include <memory>
#include <string>

#include "pellucida/operation/OperatorConsole.h"
#include "pellucida/pipeline/LiveRun.h"

namespace pellucida {

/// Options of the window.
struct WindowOptions {
  std::string session_folder;       ///< where Record writes; empty: a new folder in ~/Pellucida each time
  std::string screenshot;           ///< save the window as this PNG file, then close; empty: stay open
  double screenshot_after_s = 8.0;  ///< time from the window's opening to the screenshot, > 0
  bool repeat = false;              ///< restart the source a moment after its end, if it can
  int hand = -1;                    ///< index of the console's hand at the start; -1: none
  int width_px = 1400;              ///< size at the start
  int height_px = 900;
};

/// Opens the window on `run`, starts the run, and returns the event loop's exit status when the window is closed.
/// Needs an X server; main thread only. Throws DeviceError when no window can be opened, OutputError when the
/// screenshot can't be written.
int run_workstation(std::unique_ptr<LiveRun> run, const WindowOptions& options);

/// The same with a hand on the pipette: `console` belongs to `run`.
int run_workstation(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console,
                    const WindowOptions& options);

}  // namespace pellucida
