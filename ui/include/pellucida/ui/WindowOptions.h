#pragma once
#include <string>

namespace pellucida {

/// What a window's run returns in place of the event loop's exit status when the person wants the start page next.
inline constexpr int kToStartPage = 1000;

/// Options of a window in any mode.
struct WindowOptions {
  std::string screenshot;  ///< save the window as this PNG file, then close; with no `figures` either, empty: stay open
  double screenshot_after_s = 8.0;  ///< time from the window's opening to the screenshot or the figures, > 0
  std::string theme;                ///< dark or light; empty: the one chosen last
  std::string language;             ///< en or de; empty: the one chosen last, else the system's
  int width_px = 1400;              ///< size at the start
  int height_px = 900;
  bool remembered_size = true;  ///< rather the size it last had, where one is remembered
  std::string figures;          ///< write how fast the window was to this JSON file, then close; empty: nowhere
  int stop_descriptor = -1;     ///< once it can be read, the window closes as if a person had closed it; -1: none
};

}  // namespace pellucida
