#pragma once
#include <memory>
#include <optional>
#include <string>

#include "pellucida/core_vtk/FrameSource.h"

namespace pellucida {

/// What the user states about an input; overrides the file's own metadata.
struct SourceOptions {
  std::optional<double> pixel_size_um;  ///< `--pixel-size-um`, 0.001..100
  std::optional<double> frame_rate_hz;  ///< `--fps`, 0.001..100000
  /// `--max-megapixels`: an image of more is refused before memory is taken for it; 10 bytes a pixel are, at most.
  double most_megapixels = 100.0;
};

/// Opens whatever `input` names: a video file, a folder of images (PNG, TIFF, JPEG, BMP; natural order of their names),
/// one multi-page TIFF (a time series), one still, or a camera `v4l2:N`.
///
/// Pixel size and frame rate come from the options, else from the metadata (TIFF resolution with its unit, ImageJ's or
/// OME's description, PNG's physical size; the container's frame rate), else the input is refused. Colour becomes grey
/// by luminance (Rec. 601); 16 bit stays 16 bit.
///
/// Errors, in the order of the checks:
/// - InputError: missing, empty, of an unknown format, damaged, larger than `most_megapixels`, or with pixels that are
/// neither 8 nor 16 bit integers;
/// - DeviceError: the camera isn't there or may not be opened, or this build has no such kind of source;
/// - UsageError: an option out of range, or a pixel size or frame rate that neither option nor metadata gives.
/// Every later frame has the size and depth of the first; any other is an InputError of `next()`.
/// An empty image in a folder is an InputError in its turn: left out, it would shift the times behind it.
std::unique_ptr<FrameSource> open_source(const std::string& input, const SourceOptions& options);

}  // namespace pellucida
