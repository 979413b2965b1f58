#pragma once
#include <sys/types.h>
#include <string>

namespace pellucida {

/// True when an X server answers at `display` (nullptr: the value of DISPLAY).
bool display_answers(const char* display = nullptr) noexcept;

/// Ensures that there is an X server to draw with, for the lifetime of this object. If DISPLAY names one that answers,
/// nothing happens. Otherwise a private Xvfb is started (24 bit, no TCP, dies with this process), DISPLAY points to it
/// until the destructor puts the old value back, and one line on stderr reports it. Create and destroy on the main
/// thread (it changes the environment; Xvfb is bound to the creating thread's life), and destroy it after the last
/// window that draws there. Throws DeviceError when there is no display and Xvfb can't be started; the text names the
/// package.
class VirtualDisplay {
 public:
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  /// True when a server of our own was started.
  bool started() const noexcept { return server_ > 0; }

 private:
  pid_t server_ = 0;
  std::string old_display_;
  bool had_display_ = false;
};

}  // namespace pellucida
