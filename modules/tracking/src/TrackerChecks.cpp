#include "TrackerChecks.h"

#include <cmath>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

void require(bool holds, const char* name, const char* range, double value) {
  if (!holds)
    throw UsageError(std::string("tracker option ") + name + " is " + std::to_string(value) + "; give a value " +
                     range);
}

}  // namespace

void check(const TrackerOptions& o) {
  require(o.min_cell_diameter_px >= 16.0, "min_cell_diameter_px", "of 16 or more", o.min_cell_diameter_px);
  require(o.max_cell_diameter_px > o.min_cell_diameter_px, "max_cell_diameter_px", "above min_cell_diameter_px",
          o.max_cell_diameter_px);
  require(o.expected_radius_um >= 0.0 && std::isfinite(o.expected_radius_um), "expected_radius_um", "of 0 or more",
          o.expected_radius_um);
  require(o.contour_point_count >= 64 && o.contour_point_count <= 512, "contour_point_count", "in 64..512",
          o.contour_point_count);
  require(o.edge_scale_px >= 0.5 && o.edge_scale_px <= 10.0, "edge_scale_px", "in 0.5..10", o.edge_scale_px);
  require(o.search_px >= 1.0 && o.search_px <= 100.0, "search_px", "in 1..100", o.search_px);
  require(o.wide_search_px >= o.search_px && o.wide_search_px <= 200.0, "wide_search_px", "in search_px..200",
          o.wide_search_px);
  require(o.snake_iterations >= 1 && o.snake_iterations <= 50, "snake_iterations", "in 1..50", o.snake_iterations);
  require(o.elasticity >= 0.0 && o.rigidity >= 0.0 && o.tip_rigidity > 0.0 && o.tip_rigidity <= o.rigidity,
          "tip_rigidity", "above 0 and not above rigidity", o.tip_rigidity);
  require(o.redetect_interval_frames >= 1, "redetect_interval_frames", "of 1 or more", o.redetect_interval_frames);
}

void check(const ImageView& image) {
  if (image.data == nullptr) throw UsageError("tracker: the image has no pixels");
  if (image.width_px < 1 || image.height_px < 1)
    throw UsageError("tracker: the image is " + std::to_string(image.width_px) + " x " +
                     std::to_string(image.height_px) + " px; both must be 1 or more");
  const std::ptrdiff_t pixel_bytes = image.format == PixelFormat::kGray16 ? 2 : 1;
  if (image.row_bytes < image.width_px * pixel_bytes)
    throw UsageError("tracker: the image's rows have " + std::to_string(image.row_bytes) + " bytes; " +
                     std::to_string(image.width_px * pixel_bytes) + " are needed");
  if (!(image.pixel_size_um > 0.0) || !std::isfinite(image.pixel_size_um))
    throw UsageError("tracker: the pixel size is " + std::to_string(image.pixel_size_um) + " um; give one above 0");
}

void check(const FrameHints& hints) {
  if (hints.needle_motion_um && !hints.needle_motion_um->allFinite())
    throw UsageError("tracker: the needle's commanded motion is not finite; give um, or leave it out");
}

void check_place(const Eigen::Vector2d& place_um) {
  if (!place_um.allFinite()) throw UsageError("tracker: the hint's place is not finite; give a point of the image, um");
}

void check(const CellHint& hint) {
  if (!hint.inside_um && !hint.outline_um)
    throw UsageError("tracker: the hint has neither a point nor an outline; give one of the two");
  if (hint.inside_um && !hint.inside_um->allFinite())
    throw UsageError("tracker: the hint's point is not finite; give a point of the image, um");
  if (!hint.outline_um) return;
  if (hint.outline_um->cols() < 3)
    throw UsageError("tracker: the hint's outline has " + std::to_string(hint.outline_um->cols()) +
                     " points; give 3 or more");
  if (!hint.outline_um->allFinite())
    throw UsageError("tracker: the hint's outline has a point that is not finite; give points of the image, um");
}

}  // namespace pellucida
