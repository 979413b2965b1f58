#include "pellucida/teleoperation/EppendorfLine.h"

#include <cmath>
#include <cstdlib>

#include "SteadyTime.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr int kBaud = 19200;
constexpr double kWriteTimeout_s = 0.5;
constexpr long kFarEnough_um = 100;  // half a um of rounding is half a percent there

/// Noise as it can be shown on a terminal.
std::string printable(std::string text) {
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

}  // namespace

EppendorfLine::EppendorfLine(const std::string& port) : port_(port, kBaud) {}

std::string EppendorfLine::where() const {
  return "Eppendorf manipulator at " + port_.path() + ": ";
}

void EppendorfLine::pass_over(const std::string& line) {
  last_stray_ = printable(line);
  ++stray_line_count_;
}

bool EppendorfLine::await(EppendorfCode code, double timeout_s, EppendorfAnswer& answer) {
  const double deadline_s = steady_now_s() + timeout_s;
  while (true) {
    while (const auto line = lines_.next()) {
      if (const auto found = eppendorf_answer(*line); found && found->code == static_cast<int>(code)) {
        answer = *found;
        return true;
      }
      pass_over(*line);
    }
    const double left_s = deadline_s - steady_now_s();
    if (left_s <= 0.0) return false;
    char bytes[64];
    lines_.push({bytes, port_.read(bytes, sizeof bytes, left_s)});
  }
}

EppendorfAnswer EppendorfLine::ask(EppendorfCode code, const std::string& command, double timeout_s) {
  // What is still on its way belongs to an earlier question.
  port_.discard_input();
  lines_.clear();
  last_stray_.clear();
  // Once more when no answer comes: a bit may have been lost on the line. All our commands may be given twice.
  for (int attempt = 0; attempt < 2; ++attempt) {
    EppendorfAnswer answer;
    try {
      port_.write(command, kWriteTimeout_s);
      if (await(code, timeout_s, answer)) return answer;
    } catch (const DeviceError& fault) {
      throw DeviceError(where() + fault.what());
    }
  }
  throw DeviceError(where() + "no answer to " + command.substr(0, 4) + " within " + std::to_string(timeout_s) +
                    " s, asked twice" +
                    (last_stray_.empty() ? "" : "; the last line received was \"" + last_stray_ + "\"") +
                    "; check that it is switched on and set to 19200 baud");
}

EppendorfPosition EppendorfLine::ask_position(EppendorfCode code, double timeout_s) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    const EppendorfAnswer answer = ask(code, timeout_s);
    if (const auto position = eppendorf_position(answer)) return *position;
    pass_over(answer.text);
  }
  throw DeviceError(where() + "its position arrived as \"" + last_stray_ +
                    "\", not as three coordinates and the limit switches");
}

EppendorfIdentity ask_identity(const std::string& port, double timeout_s) {
  EppendorfLine line(port);
  EppendorfIdentity identity;
  identity.version = line.ask(EppendorfCode::kVersion, timeout_s).text;
  identity.microsteps = line.ask_position(EppendorfCode::kPositionMicrosteps, timeout_s);
  identity.micrometres = line.ask_position(EppendorfCode::kPositionMicrometres, timeout_s);
  long farthest_um = kFarEnough_um - 1;
  for (int axis = 0; axis < 3; ++axis) {
    const long um = std::labs(identity.micrometres.coordinates[axis]);
    if (um <= farthest_um) continue;
    farthest_um = um;
    identity.microsteps_per_um =
        static_cast<double>(std::labs(identity.microsteps.coordinates[axis])) / static_cast<double>(um);
  }
  return identity;
}

}  // namespace pellucida
