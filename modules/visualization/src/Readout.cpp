#include "pellucida/visualization/Readout.h"

#include <cmath>
#include <cstdio>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

constexpr const char* kDash = "\u2013";

std::string with_unit(double value, int decimals, const char* unit) {
  return std::isfinite(value) ? readout::number(value, decimals) + " " + unit : kDash;
}

// Part of WCAG's relative luminance.
double linear(double part) noexcept {
  return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

double luminance(const Color& c) noexcept {
  return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

}  // namespace

namespace readout {

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return kDash;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  // "-0.0" would flicker beside "0.0".
  std::string result = text;
  if (result.find_first_of("123456789") == std::string::npos && result.front() == '-') result.erase(0, 1);
  return result;
}

std::string plain(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string state(std::optional<CellState> state) {
  if (!state) return kDash;
  switch (*state) {
    case CellState::kNoCell:
      return say("No cell");
    case CellState::kFree:
      return say("Free");
    case CellState::kContact:
      return say("Contact");
    case CellState::kPunctured:
      return say("Punctured");
    case CellState::kLost:
      return say("Lost");
  }
  return kDash;
}

std::string indentation(const Measurement& m) {
  return with_unit(m.indentation_um, 1, "µm");
}
std::string force(const Measurement& m) {
  return with_unit(m.contact_force_uN, 2, "µN");
}

std::string force_interval(const Measurement& m) {
  if (!std::isfinite(m.contact_force_lower_uN) || !std::isfinite(m.contact_force_upper_uN)) return {};
  return number(m.contact_force_lower_uN, 2) + " \u2013 " + number(m.contact_force_upper_uN, 2) + " µN";
}

std::string force_parts(const Measurement& m) {
  std::string text = to_string(force_spread(m));
  for (std::size_t at = text.find("+-"); at != std::string::npos; at = text.find("+-", at)) text.replace(at, 2, "±");
  for (const char* part :
       {PELLUCIDA_WORDS("picture "), PELLUCIDA_WORDS("kind of cell "), PELLUCIDA_WORDS("this cell ")}) {
    const std::size_t at = text.find(part);
    if (at != std::string::npos) text.replace(at, std::char_traits<char>::length(part), say(part));
  }
  return text;
}

std::string pressure(const Measurement& m) {
  return with_unit(m.pressure_Pa, 0, "Pa");
}
std::string confidence(const Measurement& m) {
  return with_unit(100.0 * m.confidence, 0, "%");
}
std::string time(double time_s) {
  return with_unit(time_s, 2, "s");
}
std::string milliseconds(double value_ms) {
  return with_unit(value_ms, 0, "ms");
}

}  // namespace readout

std::string Color::css() const {
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(std::lround(255.0 * red)),
                static_cast<unsigned>(std::lround(255.0 * green)), static_cast<unsigned>(std::lround(255.0 * blue)));
  return text;
}

double contrast_ratio(const Color& a, const Color& b) noexcept {
  const double bright = std::max(luminance(a), luminance(b));
  const double dark = std::min(luminance(a), luminance(b));
  return (bright + 0.05) / (dark + 0.05);
}

Color state_color(std::optional<CellState> state, const ThemeColors& theme) noexcept {
  const auto of = [&](std::uint32_t on_dark, std::uint32_t on_light) {
    return Color::from_hex(theme.is_light ? on_light : on_dark);
  };
  switch (state.value_or(CellState::kNoCell)) {
    case CellState::kFree:
      return of(0x6CB6F5, 0x1A66A8);
    case CellState::kContact:
      return of(0x4ADE9C, 0x0B6E44);
    case CellState::kPunctured:
      return of(0xFF7A7A, 0xB3261E);
    case CellState::kLost:
      return theme.warning;
    case CellState::kNoCell:
      break;
  }
  return of(0x93A1B1, 0x566270);
}

}  // namespace pellucida
