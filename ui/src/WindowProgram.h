#pragma once
#include <QApplication>
#include <memory>

#include "pellucida/visualization/Palette.h"

namespace pellucida {

/// Qt and VTK, set up for a window of this program. One at a time, on the main thread.
class WindowProgram {
 public:
  /// Throws DeviceError when the display doesn't answer.
  explicit WindowProgram(const ThemeColors& theme = dark_theme());

  /// Shows `window` until it is closed; the event loop's exit status.
  int show(QWidget& window);

 private:
  // Qt keeps references to both.
  int argument_count_ = 1;
  char name_[10] = "pellucida";
  char* arguments_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

}  // namespace pellucida
