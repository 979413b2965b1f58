#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "pellucida/start/StartChoice.h"
#include "pellucida/ui/WindowOptions.h"

namespace pellucida {

/// Options of the start page.
struct StartOptions : WindowOptions {
  std::string problem;                    ///< why the last choice came to nothing, shown on its card; empty: no problem
  std::filesystem::path recording;        ///< file or folder to fill in; empty: none
  std::filesystem::path settings_file;    ///< what is remembered; empty: `Pellucida/start.ini` in the user's settings
  std::filesystem::path sessions_folder;  ///< whose newest sessions are offered; empty: `Pellucida` in the home folder
  std::filesystem::path cameras_listing = "/sys/class/video4linux";  ///< the system's folder of cameras
};

/// Opens the start page, and returns what the person chose, or nothing when it was closed. Remembers the choice and
/// the window's size; settings that are damaged or can't be written leave the defaults. Needs an X server; main thread
/// only. Throws DeviceError when no window can be opened, InputError for a damaged scenario, profile or lesson among
/// the resources, OutputError when the screenshot can't be written.
std::optional<StartChoice> run_start(const StartOptions& options);

}  // namespace pellucida
