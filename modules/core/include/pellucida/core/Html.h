#pragma once
#include <string>
#include <string_view>

namespace pellucida {

/// `text` as content or as a quoted attribute of HTML and SVG: markup characters as entities, control characters as
/// spaces, bytes that are no UTF-8 as the replacement character.
std::string html_text(std::string_view text);
/// `path` as a link relative to the page: what is no letter, digit or one of "-._~/" is percent-encoded.
std::string html_link(std::string_view path);

/// Decimals that give a number three significant digits: 0 to 4.
int decimals_of(double value) noexcept;
/// "7.46"; never an exponent, never "-0.00"; an en dash for what is not a finite number.
std::string fixed_number(double value, int decimals);

/// A unit as people write it: "uN/um" as "µN/µm".
std::string unit_text(std::string_view unit);

}  // namespace pellucida
