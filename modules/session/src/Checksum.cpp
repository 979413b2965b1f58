#include "Checksum.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace pellucida {

std::uint32_t crc32_of(std::string_view content) noexcept {
  return static_cast<std::uint32_t>(
      ::crc32_z(0, reinterpret_cast<const unsigned char*>(content.data()), content.size()));
}

std::string crc32_text(std::uint32_t checksum) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(checksum));
  return text;
}

std::optional<std::uint32_t> crc32_from(std::string_view text) noexcept {
  std::uint32_t checksum = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), checksum, 16);
  if (text.size() != 8 || code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  // One spelling, so that a letter that was changed to its capital is seen, too.
  if (std::any_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'F'; })) return std::nullopt;
  return checksum;
}

std::string signed_row(std::string_view row) {
  return std::string(row) + ',' + crc32_text(crc32_of(row));
}

std::optional<std::string_view> verified_row(std::string_view line) noexcept {
  if (line.size() < kRowChecksumBytes || line[line.size() - kRowChecksumBytes] != ',') return std::nullopt;
  const std::string_view row = line.substr(0, line.size() - kRowChecksumBytes);
  const auto checksum = crc32_from(line.substr(row.size() + 1));
  if (!checksum || *checksum != crc32_of(row)) return std::nullopt;
  return row;
}

}  // namespace pellucida
