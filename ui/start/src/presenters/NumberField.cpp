#include "presenters/NumberField.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "pellucida/core/Table.h"
#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

}  // namespace

TypedNumber read_number(std::string_view text, const NumberKind& kind) {
  std::string digits = trimmed(text);
  if (digits.empty()) return {};
  const std::string typed = digits;
  if (std::count(digits.begin(), digits.end(), ',') == 1 && digits.find('.') == std::string::npos) {
    digits[digits.find(',')] = '.';
  }
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto [rest, fault] = std::from_chars(digits.data(), end, value);
  if (rest != end || (fault != std::errc{} && fault != std::errc::result_out_of_range)) {
    return {{},
            "\"" + typed + say("\" is no number: give the ") + say(kind.name) + say(" in ") + say(kind.unit) +
                say(", such as ") + kind.example};
  }
  // Written so that NaN fails too.
  if (fault == std::errc{} && value >= kind.range.lower && value <= kind.range.upper) return {value, {}};
  return {{},
          typed + say(" is out of range: give a ") + say(kind.name) + say(" of ") + csv_number(kind.range.lower) +
              say(" to ") + csv_number(kind.range.upper) + " " + say(kind.unit)};
}

double specimen_pixel_um(double camera_pixel_um, double magnification) noexcept {
  return camera_pixel_um / magnification;
}

}  // namespace pellucida
