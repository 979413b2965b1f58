#pragma once
#include <memory>

#include "pellucida/core/ImageView.h"
#include "pellucida/core/Observation.h"
#include "pellucida/tracking/TrackerOptions.h"
#include "pellucida/tracking/TrackerTimings.h"
#include "pellucida/tracking/TrackingHints.h"

namespace pellucida {

/// Follows both membranes of a cell, the needle and the holding pipette from frame to frame: active contours (snakes),
/// as in the paper, started by a detection that needs no click. Method and equations: docs/method.md, section 1. Has
/// memory: frames of one sequence in order; `reset` starts again. One thread at a time.
class MembraneTracker {
 public:
  /// Throws UsageError when an option is out of its range; the text names it.
  explicit MembraneTracker(TrackerOptions options = {});
  ~MembraneTracker();
  MembraneTracker(MembraneTracker&&) noexcept;
  MembraneTracker& operator=(MembraneTracker&&) noexcept;

  /// Evaluates one frame. `time_s` since the session began. The image is read during the call only. Throws UsageError
  /// for an image without data, with sizes below 1, rows shorter than the width, or a pixel size that is not above 0,
  /// or a motion that is not finite. An image that shows nothing is not an error: the state is then `no_cell` or
  /// `lost`. If the image's size changes, the cell is searched for again.
  Observation process(const ImageView& image, double time_s, long frame_index, const FrameHints& hints = {});

  /// Forgets the cell and searches for it where the user points, in the next frame. A hint that leads nowhere is
  /// dropped after that frame, and the usual search continues. Throws UsageError for a hint without point or outline,
  /// an outline of fewer than 3 points, or numbers that are not finite.
  void expect_cell(const CellHint& hint);

  /// Forgets the cell, the needle, the holder and everything learnt about them.
  void reset();

  const TrackerOptions& options() const noexcept;

  /// Time spent on the parts of the last frame.
  const TrackerTimings& timings() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
