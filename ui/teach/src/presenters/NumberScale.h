#pragma once
#include <string>

namespace pellucida {

/// A number that has a slider: its name, its ends, and how the slider's places (0 to 1) become numbers.
struct NumberScale {
  const char* name = "";  ///< in English; said by whoever shows it
  const char* tip = "";
  double low = 0.0;
  double high = 1.0;
  bool is_log = false;
  double key_step = 0.01;  ///< the least change by an arrow key, as a place
  bool is_whole = false;
  std::string (*text)(double value) = nullptr;  ///< with its unit

  /// The number at a place, and the place of a number; what is beyond the ends is held there.
  double value_at(double place) const noexcept;
  double place_of(double value) const noexcept;
};

/// Which part of a slider is stable while all other parameters stay: places from and to, 0 to 1, and that in words;
/// empty words where the slider has no such part.
struct StablePart {
  double from = 0.0;
  double to = 1.0;
  std::string text;
};

/// "15 ms", "146 µs".
std::string duration_text(double time_us);
/// As short as a value on a slider.
std::string three_digits(double value);
/// As a figure: no more than three decimals.
std::string short_number(double value);

}  // namespace pellucida
