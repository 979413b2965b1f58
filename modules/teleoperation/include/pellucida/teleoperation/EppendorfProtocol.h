#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pellucida {

/// The serial protocol of Eppendorf's motorised micromanipulators, as printed in the operating manual of the PatchMan
/// NP 2, appendix "PC interface" (docs/devices.md has the sources and what they leave open). 19200 baud, 8N1, ASCII
/// lines: a command "C012 100-200+300 50 50 50" ended by CR, its answer "A012". Numbers are whole; a space or a sign
/// separates them. Pure: no port, no time.
enum class EppendorfCode : int {
  kVersion = 1,
  kRemoteControl = 4,
  kManualControl = 5,
  kStop = 8,
  kPositionMicrosteps = 9,
  kPositionMicrometres = 10,
  kGoToMicrosteps = 11,   ///< answered at once, before the motion ends
  kGoToMicrometres = 12,  ///< the same in um and um/s
};

/// A command without numbers, its CR included.
std::string eppendorf_command(EppendorfCode code);

/// A motion: where to, and how fast each axis; speed 0 leaves an axis where it is.
std::string eppendorf_go_to(EppendorfCode code, const std::array<long, 3>& position, const std::array<long, 3>& speed);

/// One answer. `numbers` holds those that follow the code, at most `kMaxNumbers`.
struct EppendorfAnswer {
  static constexpr std::size_t kMaxNumbers = 6;
  int code = 0;
  std::array<long, kMaxNumbers> numbers{};
  std::size_t number_count = 0;  ///< 0 also if text follows (the version)
  std::string text;              ///< everything after the code, as received, without surrounding spaces
};

/// The answer in one line without its end; nothing when it is not an answer ("A", three digits, then nothing, or a
/// space or sign).
std::optional<EppendorfAnswer> eppendorf_answer(std::string_view line);

/// A position answer: three coordinates and the limit switches (0: none reached). Nothing when numbers are missing.
struct EppendorfPosition {
  std::array<long, 3> coordinates{};
  long limit_switches = 0;
};
std::optional<EppendorfPosition> eppendorf_position(const EppendorfAnswer& answer);

/// Cuts a stream of bytes into lines at CR, LF or both. Empty lines are skipped. A line longer than `kMaxLength` is
/// noise: it is dropped to its end and counted.
class LineSplitter {
 public:
  static constexpr std::size_t kMaxLength = 128;

  void push(std::string_view bytes);

  /// The next complete line; nothing when there is none yet.
  std::optional<std::string> next();

  void clear() noexcept;
  std::size_t dropped_count() const noexcept { return dropped_count_; }

 private:
  std::string bytes_;
  std::size_t dropped_count_ = 0;
  bool dropping_ = false;
};

}  // namespace pellucida
