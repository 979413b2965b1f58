#include "PhysicalSize.h"

#include <cmath>
#include <regex>

namespace pellucida {
namespace {

constexpr double kCoarsestPixel_um = 20.0;

// Micrometres in a unit as metadata spell it; nothing for a unit unknown (also "pixel").
std::optional<double> unit_in_um(const std::string& unit) {
  // The micro sign comes as UTF-8 (two code points look alike), as Latin-1, or as ImageJ's escape.
  for (const char* name :
       {"um", "micron", "microns", "micrometer", "micrometre", "\xC2\xB5m", "\xCE\xBCm", "\xB5m", "\\u00B5m"}) {
    if (unit == name) return 1.0;
  }
  if (unit == "nm") return 1e-3;
  if (unit == "mm") return 1e3;
  if (unit == "cm") return 1e4;
  if (unit == "m") return 1e6;
  if (unit == "inch" || unit == "in") return 25400.0;
  return std::nullopt;
}

// The first group of `pattern` in `text`; nothing when it isn't there.
std::optional<std::smatch> find(const std::string& text, const char* pattern) {
  std::smatch match;
  if (!std::regex_search(text, match, std::regex(pattern, std::regex::icase))) return std::nullopt;
  return match;
}

std::optional<double> find_number(const std::string& text, const char* pattern) {
  const auto match = find(text, pattern);
  if (!match) return std::nullopt;
  const double value = std::strtod((*match)[1].str().c_str(), nullptr);
  return std::isfinite(value) && value > 0.0 ? std::optional(value) : std::nullopt;
}

std::optional<double> described_pixel_size_um(const std::string& text, double x_per_unit, bool square) {
  // OME names value and unit as attributes.
  if (const auto size = find_number(text, R"rx(PhysicalSizeX="([0-9.eE+-]+)")rx")) {
    const auto unit = find(text, R"rx(PhysicalSizeXUnit="([^"]+)")rx");
    const auto um = unit ? unit_in_um((*unit)[1].str()) : std::optional(1.0);
    if (um) return plausible_pixel_size_um(*size * *um);
  }
  // Plain words.
  if (const auto match = find(text, R"rx(pixel[ _-]?(?:width|size)\s*[=:]\s*([0-9.eE+-]+)\s*([^\s,;]+))rx")) {
    if (const auto um = unit_in_um((*match)[2].str())) {
      return plausible_pixel_size_um(std::strtod((*match)[1].str().c_str(), nullptr) * *um);
    }
  }
  // ImageJ names the unit here, and puts pixels a unit into the resolution.
  if (const auto match = find(text, R"rx((?:^|\n)unit=([^\r\n]+))rx"); match && square) {
    if (const auto um = unit_in_um((*match)[1].str())) return plausible_pixel_size_um(*um / x_per_unit);
  }
  return std::nullopt;
}

std::optional<double> described_frame_rate_hz(const std::string& text) {
  if (const auto interval_s = find_number(text, R"rx(TimeIncrement="([0-9.eE+-]+)")rx")) return 1.0 / *interval_s;
  if (const auto interval_s = find_number(text, R"rx((?:^|\n)finterval=([0-9.eE+-]+))rx")) return 1.0 / *interval_s;
  return find_number(text, R"rx((?:^|\n)fps=([0-9.eE+-]+))rx");
}

}  // namespace

std::optional<double> plausible_pixel_size_um(double pixel_size_um) {
  // 72 or 300 dots an inch (353 or 85 um) fall out here.
  if (!std::isfinite(pixel_size_um) || pixel_size_um <= 0.0 || pixel_size_um > kCoarsestPixel_um) return std::nullopt;
  return pixel_size_um;
}

PhysicalSize physical_size(const std::string& description, double x_per_unit, double y_per_unit, ResolutionUnit unit) {
  const bool square = x_per_unit > 0.0 && std::abs(y_per_unit - x_per_unit) <= 0.01 * x_per_unit;
  PhysicalSize size;
  size.frame_rate_hz = described_frame_rate_hz(description);
  size.pixel_size_um = described_pixel_size_um(description, x_per_unit, square);
  if (!size.pixel_size_um && square && unit != ResolutionUnit::kNone) {
    const double unit_um = unit == ResolutionUnit::kInch ? 25400.0 : 1e4;
    size.pixel_size_um = plausible_pixel_size_um(unit_um / x_per_unit);
  }
  return size;
}

}  // namespace pellucida
