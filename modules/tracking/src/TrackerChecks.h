#pragma once
#include "pellucida/core/ImageView.h"
#include "pellucida/tracking/TrackerOptions.h"
#include "pellucida/tracking/TrackingHints.h"

namespace pellucida {

/// Throws UsageError that names the option, its value and its range.
void check(const TrackerOptions& options);
/// Throws UsageError for an image without data, with sizes below 1, rows shorter than the width, or a pixel size that
/// is not above 0.
void check(const ImageView& image);
/// Throws UsageError for a motion that is not finite.
void check(const FrameHints& hints);
void check_place(const Eigen::Vector2d& place_um);
/// Throws UsageError for a hint without point or outline, an outline of fewer than 3 points, numbers that are not
/// finite.
void check(const CellHint& hint);

}  // namespace pellucida
