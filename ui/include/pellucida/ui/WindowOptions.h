#pragma once
#include <string>

namespace pellucida {

/// Options of a window in any mode.
struct WindowOptions {
  std::string screenshot;           ///< save the window as this PNG file, then close; empty: stay open
  double screenshot_after_s = 8.0;  ///< time from the window's opening to the screenshot, > 0
  int width_px = 1400;              ///< size at the start
  int height_px = 900;
};

}  // namespace pellucida
