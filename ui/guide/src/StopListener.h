#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace pellucida {

/// A button's place in a window of the X server; pixels of the server, not of the desktop's scaling.
struct ButtonPlace {
  std::uint32_t window = 0;  ///< the server's name of the window; 0: there is none
  int left_px = 0, top_px = 0, width_px = 0, height_px = 0;
};

/// Listens for the emergency stop on a thread of its own with its own connection to the X server, so that whatever
/// keeps the window's thread busy, a rendering above all, does not delay it: Esc pressed without Shift while the
/// program is the active one, or a mouse button pressed on the stop button wherever it is not covered. It takes nothing
/// away: the window sees the same key and the same click when it gets to them.
///
/// Needs an X server with XInput 2. Elsewhere (Wayland, another platform) `trouble` says so, and the stop is as late
/// as the window's own events.
class StopListener {
 public:
  /// `stop` is called on the listener's thread: any number of times, never before the constructor or after the
  /// destructor. It must neither throw nor wait.
  explicit StopListener(std::function<void()> stop);
  ~StopListener();
  StopListener(const StopListener&) = delete;
  StopListener& operator=(const StopListener&) = delete;

  /// Why it does not listen, one line; empty when it does.
  const std::string& trouble() const noexcept;

  /// Any thread: whether keys are meant for this program.
  void set_active(bool active) noexcept;
  /// Any thread.
  void set_button(const ButtonPlace& place) noexcept;

 private:
  class Connection;
  std::string trouble_;
  std::unique_ptr<Connection> connection_;
};

}  // namespace pellucida
