#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "pellucida/teleoperation/EppendorfProtocol.h"
#include "pellucida/teleoperation/SerialPort.h"

namespace pellucida {

/// Question and answer with an Eppendorf manipulator over a serial port, each with a deadline. A line that is not the
/// expected answer (noise, an echo, a late answer) is skipped and counted; a question without an answer is asked once
/// more before the device counts as lost.
class EppendorfLine {
 public:
  /// Throws DeviceError as SerialPort.
  explicit EppendorfLine(const std::string& port);

  /// The answer to `command`, whose code is `code`. Throws DeviceError: port and command, what arrived instead, what to
  /// check.
  EppendorfAnswer ask(EppendorfCode code, const std::string& command, double timeout_s);
  EppendorfAnswer ask(EppendorfCode code, double timeout_s) { return ask(code, eppendorf_command(code), timeout_s); }

  /// Its position, in microsteps or um according to `code`. Throws DeviceError, also for an answer that is not a
  /// position.
  EppendorfPosition ask_position(EppendorfCode code, double timeout_s);

  std::uint64_t stray_line_count() const noexcept { return stray_line_count_; }

 private:
  bool await(EppendorfCode code, double timeout_s, EppendorfAnswer& answer);
  void pass_over(const std::string& line);
  std::string where() const;

  SerialPort port_;
  LineSplitter lines_;
  std::string last_stray_;
  std::uint64_t stray_line_count_ = 0;
};

/// What a manipulator reports about itself without being moved or taken from its joystick.
struct EppendorfIdentity {
  std::string version;  ///< "5181 V1.04"
  EppendorfPosition microsteps, micrometres;
  /// From the axis farthest from zero; 0 when none is 100 um away, where whole um are too coarse.
  double microsteps_per_um = 0.0;
};

/// Asks at `port`. Throws DeviceError when nothing there answers like an Eppendorf manipulator.
EppendorfIdentity ask_identity(const std::string& port, double timeout_s = 0.3);

}  // namespace pellucida
