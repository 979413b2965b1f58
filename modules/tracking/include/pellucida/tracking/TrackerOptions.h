#pragma once
#include <optional>
#include <string_view>

namespace pellucida {

/// The tracker's tunable numbers. Lengths are in pixels (`_px`) because they follow the optics and the sampling, not
/// the cell; what follows the cell is a ratio of its radius.
struct TrackerOptions {
  /// kLive: as fast as the camera. kHigh: for recordings, where time does not count: detection always by level sets,
  /// more rounds for each contour, and each frame read where networks read them.
  enum class Quality { kLive, kHigh };
  Quality quality = Quality::kLive;

  /// How cell and tools are found. kLines: by their dark lines, as bright field shows them; the most precise where it
  /// does. kScene: by a learnt network that knows any contrast; what the membranes look like is then learnt from the
  /// image along the outlines found. kAuto: by lines where the network sees the same cell and needle, else by the
  /// network.
  enum class Detection { kAuto, kLines, kScene };
  Detection detection = Detection::kAuto;

  // Detection.
  double min_cell_diameter_px = 36.0;  ///< of the outer membrane
  double max_cell_diameter_px = 560.0;
  /// Of the kind of cell, its outer membrane's; a ring less than 0.4 or more than 2.5 times as large is none, unless a
  /// person says so. 0: any.
  double expected_radius_um = 0.0;
  double min_detection_score = 0.50;  ///< 0..1: below this, no cell is reported
  int redetect_interval_frames = 5;   ///< while lost: how often the whole image is searched

  // Contours.
  int contour_point_count = 192;  ///< 64..512, points of a reported contour
  double edge_scale_px = 1.3;     ///< standard deviation of the edge filter along the normal
  double search_px = 9.0;         ///< half width of the band searched round the predicted contour
  double wide_search_px = 38.0;   ///< the same when the narrow search found too little
  double elasticity = 0.02;       ///< snake, alpha, relative to an edge's weight of 1
  double rigidity = 60.0;         ///< snake, beta: smooths over about beta^(1/4) points
  double tip_rigidity = 3.0;      ///< beta at the needle's tip, where the dimple is sharp
  int snake_iterations = 3;       ///< a frame and membrane

  // State.
  double min_tracking_score = 0.35;  ///< 0..1: below this, a frame does not count as tracked
  int lost_after_frames = 3;         ///< untracked frames in a row before the state is `lost`
  double contact_px = 0.5;           ///< an indentation below this is no evidence of contact; released below half of it
  double puncture_drop_ratio = 0.35;  ///< share of the dimple's depth that must vanish at once to call it a puncture
};

/// "auto", "lines", "scene".
std::string_view to_string(TrackerOptions::Detection detection) noexcept;
/// The inverse of `to_string`; nothing for an unknown name.
std::optional<TrackerOptions::Detection> detection_from_string(std::string_view name) noexcept;

}  // namespace pellucida
