#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct sp_port;

namespace pellucida {

/// A serial port of this machine.
struct SerialPortInfo {
  std::string path;         ///< "/dev/ttyUSB0"
  std::string description;  ///< as the system names it
  std::string trouble;      ///< why it can't be used, and how to correct it; empty: it can be used
};

/// The serial ports present. Empty when there are none. Throws DeviceError when libserialport isn't in this build.
std::vector<SerialPortInfo> serial_ports();

/// The version of the libserialport in use; empty in a build without it (PELLUCIDA_WITH_SERIALPORT).
std::string serial_port_library_version();

/// An open serial port, 8 data bits, no parity, 1 stop bit, no flow control, opened exclusively. Every wait has a
/// deadline. One thread at a time; never the 1 kHz thread.
class SerialPort {
 public:
  /// Throws DeviceError: no such port, no permission (and which group has it), in use, not a serial port, or no
  /// libserialport in this build.
  SerialPort(const std::string& path, int baud);

  /// Writes all of `bytes` within `timeout_s`. Throws DeviceError when the port has disappeared, or does not accept
  /// them in time.
  void write(std::string_view bytes, double timeout_s);

  /// Reads at least one byte, up to `capacity`; 0 when nothing arrived within `timeout_s`. Throws DeviceError when the
  /// port has disappeared.
  std::size_t read(char* into, std::size_t capacity, double timeout_s);

  /// Discards unread input.
  void discard_input() noexcept;

  const std::string& path() const noexcept { return path_; }

 private:
  struct Closer {
    void operator()(sp_port* port) const noexcept;
  };
  [[noreturn]] void lost(const char* doing) const;

  std::string path_;
  std::unique_ptr<sp_port, Closer> port_;
};

}  // namespace pellucida
