#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pellucida {

/// Checksums are CRC-32 as in zlib and PNG, written as eight lower-case hexadecimal digits.
std::uint32_t crc32_of(std::string_view content) noexcept;
std::string crc32_text(std::uint32_t checksum);
std::optional<std::uint32_t> crc32_from(std::string_view text) noexcept;

/// The last column of a session's tables: the checksum of the row before it, without its comma.
inline constexpr const char* kRowChecksum = "row_crc32";
/// What the checksum adds to a row, in bytes.
inline constexpr std::size_t kRowChecksumBytes = 9;

/// `row` with its checksum as the last cell.
std::string signed_row(std::string_view row);
/// The row before its checksum; nothing where the last cell is not that.
std::optional<std::string_view> verified_row(std::string_view line) noexcept;

}  // namespace pellucida
