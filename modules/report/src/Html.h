#pragma once
#include <string>
#include <string_view>

namespace pellucida {

/// `text` as HTML and SVG show it: markup characters as entities, control characters as spaces, bytes that are no UTF-8
/// as the replacement character.
std::string escaped(std::string_view text);

/// Decimals that give a number three significant digits: 0 to 4.
int decimals_of(double value) noexcept;
/// "7.46"; never an exponent, never "-0.00".
std::string fixed_number(double value, int decimals);

/// A unit as people write it: "uN/um" as "µN/µm".
std::string unit_text(std::string_view unit);

}  // namespace pellucida
