#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/session/Annotations.h"

namespace pellucida {

/// What two or three places of the image measure.
struct Measured {
  bool is_angle = false;
  double value = 0.0;       ///< um, or degrees from 0 to 180
  double half_width = 0.0;  ///< of the 95 % interval, in the same unit: what the clicks leave open
};

/// Standard deviation of a click along x and along y, in pixels of the picture: an assumption.
inline constexpr double kClickSigma_px = 0.5;

/// The distance of two places, or the angle at the second of three. The interval takes the clicks as independent and
/// `pixel_size_um` as exact; an angle's is at most 180 degrees. Nothing for an annotation that measures nothing.
std::optional<Measured> measured(const Annotation& note, double pixel_size_um);

/// "Distance 12.3 ± 0.9 µm", "Angle 41 ± 3°".
std::string words_of(const Measured& measured);

/// What was measured as a table, in the order of time, with units in its names. Throws OutputError.
void write_measured(const std::vector<Annotation>& notes, double pixel_size_um, const std::filesystem::path& file);

}  // namespace pellucida
