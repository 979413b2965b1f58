#pragma once

namespace pellucida {

/// What a user may state about an input: both ends belong to it.
struct StatedRange {
  double lower;
  double upper;
};
inline constexpr StatedRange kStatedPixelSize_um{0.001, 100.0};     ///< um a pixel
inline constexpr StatedRange kStatedFrameRate_hz{0.001, 100000.0};  ///< frames a second

}  // namespace pellucida
