#include "pellucida/core/Html.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pellucida {
namespace {

constexpr std::string_view kMicro = "\xC2\xB5", kReplacement = "\xEF\xBF\xBD";

// Length of the UTF-8 character that `text` begins with; 0 where it begins with none.
std::size_t character_length(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80U) return 1;
  const std::size_t length = lead >= 0xC2U && lead < 0xE0U ? 2
                             : lead < 0xC2U                ? 0
                             : lead < 0xF0U                ? 3
                             : lead < 0xF5U                ? 4
                                                           : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  // Overlong forms, halves of pairs, and what lies beyond Unicode.
  const bool impossible = (lead == 0xE0U && byte(1) < 0xA0U) || (lead == 0xEDU && byte(1) >= 0xA0U) ||
                          (lead == 0xF0U && byte(1) < 0x90U) || (lead == 0xF4U && byte(1) >= 0x90U);
  return impossible ? 0 : length;
}

void append_ascii(std::string& text, char character) {
  switch (character) {
    case '&':
      text += "&amp;";
      break;
    case '<':
      text += "&lt;";
      break;
    case '>':
      text += "&gt;";
      break;
    case '"':
      text += "&quot;";
      break;
    case '\'':
      text += "&#39;";
      break;
    default:
      text += static_cast<unsigned char>(character) < 0x20U || character == 0x7F ? ' ' : character;
  }
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 1) {
      append_ascii(out, text[0]);
    } else {
      out += length == 0 ? kReplacement : text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

std::string html_link(std::string_view path) {
  std::string result;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    if (plain) {
      result += c;
    } else {
      char coded[4];
      std::snprintf(coded, sizeof coded, "%%%02X", static_cast<unsigned>(byte));
      result += coded;
    }
  }
  return result;
}

int decimals_of(double value) noexcept {
  if (!std::isfinite(value) || value == 0.0) return 2;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 4);
}

std::string fixed_number(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  const double scale = std::pow(10.0, decimals);
  // What rounds to nothing has no sign.
  if (std::abs(value) * scale < 0.5) value = 0.0;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string unit_text(std::string_view unit) {
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool begins_word = i == 0 || unit[i - 1] == '/' || unit[i - 1] == ' ';
    if (unit[i] == 'u' && begins_word && i + 1 < unit.size() && (unit[i + 1] == 'N' || unit[i + 1] == 'm')) {
      text += kMicro;
    } else {
      text += unit[i];
    }
  }
  return text;
}

}  // namespace pellucida
