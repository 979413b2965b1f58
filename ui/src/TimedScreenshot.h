#pragma once
#include <exception>
#include <functional>

#include "pellucida/ui/WindowOptions.h"

class QWidget;

namespace pellucida {

/// Saves a window as a PNG file after a time and then closes it, if its options ask for that; closes it then, too, if
/// they ask for its figures alone.
class TimedScreenshot {
 public:
  /// `refresh` shows what is newest, right before the picture is taken. `window` must outlive this object.
  TimedScreenshot(QWidget& window, const WindowOptions& options, std::function<void()> refresh);

  /// Throws OutputError when the picture couldn't be written.
  void rethrow_fault() const {
    if (fault_) std::rethrow_exception(fault_);
  }

 private:
  std::exception_ptr fault_;
};

}  // namespace pellucida
