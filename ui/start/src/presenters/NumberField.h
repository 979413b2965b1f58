#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "pellucida/acquisition/StatedRange.h"
#include "pellucida/core/Words.h"

namespace pellucida {

/// A number that a person may type: what it is, its unit, its range and an example. UTF-8.
struct NumberKind {
  const char* name;
  const char* unit;
  StatedRange range;
  const char* example;
};
inline constexpr NumberKind kPixelSizeNumber{PELLUCIDA_WORDS("pixel size"), "µm", kStatedPixelSize_um, "0.825"};
inline constexpr NumberKind kFrameRateNumber{PELLUCIDA_WORDS("frame rate"), PELLUCIDA_WORDS("frames/s"),
                                             kStatedFrameRate_hz, "30"};
inline constexpr NumberKind kCameraPixelNumber{PELLUCIDA_WORDS("camera pixel"), "µm", {0.5, 50.0}, "3.45"};

/// A typed number, or why it is none. Neither: nothing was typed.
struct TypedNumber {
  std::optional<double> value;
  std::string problem;  ///< a sentence with the remedy
};

/// Reads `text`, with a decimal point or comma, blanks around it ignored.
TypedNumber read_number(std::string_view text, const NumberKind& kind);

/// Edge of a pixel in the specimen, um: that of the camera's pixel over the objective's magnification (> 0).
double specimen_pixel_um(double camera_pixel_um, double magnification) noexcept;

}  // namespace pellucida
