#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "pellucida/operation/OperatorConsole.h"
#include "pellucida/pipeline/LiveRun.h"
#include "pellucida/ui/WindowOptions.h"

namespace pellucida {

/// Options of the window in Guide mode.
struct GuideOptions : WindowOptions {
  std::string session_folder;  ///< where Record writes; empty: a new folder in ~/Pellucida each time
  bool repeat = false;         ///< restart the source a moment after its end, if it can
  /// The true force of a frame, where the source is a virtual microscope: to be shown, never recorded. Any thread.
  std::function<std::optional<double>(long frame)> true_force_uN;
  std::shared_ptr<CameraExposure> exposure;  ///< of the source's camera; nullptr where it can't be set
  int hand = -1;                             ///< index of the console's hand at the start; -1: none
};

/// Opens the window in Guide mode on `run`, starts the run, and returns the event loop's exit status, or
/// `kToStartPage`, when the window is closed. `console`: the hand on that run's pipette; nullptr: none. Needs an X
/// server; main thread only. Throws DeviceError when no window can be opened, OutputError when the screenshot can't be
/// written or the recording can't be closed whole.
int run_guide(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console, const GuideOptions& options);

}  // namespace pellucida
