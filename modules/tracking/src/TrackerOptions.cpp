#include "pellucida/tracking/TrackerOptions.h"

#include <array>

namespace pellucida {
namespace {

using Detection = TrackerOptions::Detection;
constexpr std::array<std::string_view, 3> kDetectionNames{"auto", "lines", "scene"};  // by value

}  // namespace

std::string_view to_string(Detection detection) noexcept {
  return kDetectionNames[static_cast<std::size_t>(detection)];
}

std::optional<Detection> detection_from_string(std::string_view name) noexcept {
  for (const Detection detection : {Detection::kAuto, Detection::kLines, Detection::kScene})
    if (to_string(detection) == name) return detection;
  return std::nullopt;
}

}  // namespace pellucida
