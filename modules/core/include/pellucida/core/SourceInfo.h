#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace pellucida {

/// What is known about a source before its first frame.
struct SourceInfo {
  std::string name;  ///< file, folder, camera or scenario, as the user wrote it
  int width_px = 0;
  int height_px = 0;
  int bit_depth = 8;                           ///< 8 or 16
  double pixel_size_um = 0.0;                  ///< > 0
  std::string pixel_size_origin;               ///< "option", "metadata", "scenario", "session"
  double frame_rate_hz = 0.0;                  ///< > 0; of a still: 1
  std::string frame_rate_origin;               ///< "option", "metadata", "scenario", "still", "session"
  std::optional<long> frame_count;             ///< where known beforehand
  std::map<std::string, std::uint64_t> seeds;  ///< of everything random in it, by the name of its user
  bool live = false;                           ///< a camera: frames arrive at their own time
};

}  // namespace pellucida
