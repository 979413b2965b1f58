#pragma once
#include <optional>
#include <string>

namespace pellucida {

/// What a file says about its own scale.
struct PhysicalSize {
  std::optional<double> pixel_size_um;
  std::optional<double> frame_rate_hz;
};

/// How the resolution of a file is counted.
enum class ResolutionUnit { kNone, kInch, kCentimetre };

/// Reads a TIFF's resolution tags and description.
/// - OME: `PhysicalSizeX="0.825" PhysicalSizeXUnit="um"` (um where no unit is named), `TimeIncrement="0.1"` in seconds;
/// - ImageJ: `unit=micron` with the resolution in pixels a unit, `finterval=0.1` in seconds or `fps=10`;
/// - plain: `pixel width = 0.825 um`, `pixel size: 0.825 um`;
/// - resolution a centimetre or inch, when it is fine enough to be a microscope's (a pixel of at most 20 um): 72 or 300
/// dots an
///   inch say how to print, not what was seen.
/// A resolution that differs between x and y by more than 1 % says nothing here: pixels are square.
PhysicalSize physical_size(const std::string& description, double x_per_unit, double y_per_unit, ResolutionUnit unit);

/// A pixel edge as metadata, or nothing when it can't be a microscope's (not finite, not above 0, above 20 um).
std::optional<double> plausible_pixel_size_um(double pixel_size_um);

}  // namespace pellucida
