#pragma once
#include <algorithm>
#include <cmath>

namespace pellucida {

/// A colour's part or an opacity, 0 to 1, as VTK's arrays hold it: 0 to 255. What lies outside is clamped.
inline unsigned char to_byte(double part) {
  return static_cast<unsigned char>(std::lround(255.0 * std::clamp(part, 0.0, 1.0)));
}

}  // namespace pellucida
