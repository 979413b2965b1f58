#pragma once
#include <filesystem>
#include <string>

namespace pellucida {

struct WindowBenchOptions {
  std::filesystem::path program;  ///< whose window is measured
  std::filesystem::path against;  ///< another one, in turns with it; empty: none
  std::string source = "virtual";
  double seconds = 30.0;  ///< of each turn, from the window's opening on
  double minutes = 0.0;   ///< of a last turn of each program, for its memory; 0: none
};

/// What the real window does, as lines for a person and as JSON.
struct WindowBenchReport {
  std::string text;
  std::string json;
};

/// Opens the window in Guide mode at 1400 x 900 with its hand, once, or three times in turns with the other program:
/// frames drawn a second, time of the window's thread and of all threads for each, blocks, time from the process's
/// start to the first live frame, memory. Needs an X server, its own (VirtualDisplay) where there is none. Main thread
/// only. Throws DeviceError when no window can be opened, InputError for a program that ends early or writes no
/// figures.
WindowBenchReport measure_window(const WindowBenchOptions& options);

}  // namespace pellucida
