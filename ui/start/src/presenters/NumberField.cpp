#include "presenters/NumberField.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "pellucida/core/Table.h"

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
            "\"" + typed + "\" is no number: give the " + kind.name + " in " + kind.unit + ", such as " + kind.example};
  }
  // Written so that NaN fails too.
  if (fault == std::errc{} && value >= kind.range.lower && value <= kind.range.upper) return {value, {}};
  return {{},
          typed + " is out of range: give a " + kind.name + " of " + csv_number(kind.range.lower) + " to " +
              csv_number(kind.range.upper) + " " + kind.unit};
}

double specimen_pixel_um(double camera_pixel_um, double magnification) noexcept {
  return camera_pixel_um / magnification;
}

}  // namespace pellucida
