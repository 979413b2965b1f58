#pragma once
#include <string>

#include "pellucida/ui/WindowOptions.h"

namespace pellucida {

/// Options of the window in Teach mode.
struct TeachOptions : WindowOptions {
  std::string lesson;  ///< to begin with, by name or file; empty: the first
  bool large_letters = false;
};

/// Opens the window in Teach mode: a simulated cell to poke, and lessons about it. Returns the event loop's exit
/// status, or `kToStartPage`, when it is closed. Needs an X server; main thread only. Throws UsageError for an unknown
/// lesson, with those there are; InputError for a damaged one; DeviceError when no window can be opened; OutputError
/// when the screenshot can't be written.
int run_teach(const TeachOptions& options);

}  // namespace pellucida
