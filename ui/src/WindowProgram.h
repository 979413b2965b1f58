#pragma once
#include <QApplication>
#include <memory>

#include "pellucida/ui/WindowOptions.h"

namespace pellucida {

class Translation;

/// Qt and VTK, set up for a window of this program. One at a time, on the main thread.
class WindowProgram {
 public:
  /// In the theme and the language that `options` name, or else in those chosen last. Throws DeviceError when the
  /// display doesn't answer, InputError when the resources lack a language's texts.
  explicit WindowProgram(const WindowOptions& options);

  ~WindowProgram();

  /// Shows `window` until it is closed, by a person or by `options.stop_descriptor`, which closes its dialogs too; the
  /// event loop's exit status, or `kToStartPage`.
  int show(QWidget& window, const WindowOptions& options);

 private:
  // Qt keeps references to both.
  int argument_count_ = 1;
  char name_[10] = "pellucida";
  char* arguments_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
  std::unique_ptr<Translation> translation_;
};

}  // namespace pellucida
