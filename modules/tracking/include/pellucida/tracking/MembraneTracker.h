#pragma once
#include <Eigen/Core>
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

  /// Looks for the needle's tip where the user points, in the next frame. Where no needle can be followed the needle is
  /// what it was. Throws UsageError for a place that is not finite, as those below.
  void expect_needle(const Eigen::Vector2d& tip_um);

  /// Looks for the cell's holding pipette where the user points, in the next frame: at a place on it outside the cell.
  /// It is this cell's; one that is found anew has its own looked for as usual. The rotation counts from there. Where
  /// no straight pipette can be found, or no cell is followed, the holder is what it was.
  void expect_holder(const Eigen::Vector2d& place_um);

  /// What is at that place is no cell: it is given up, and not taken for a cell again until the hint is taken back, a
  /// cell is expected there, or `reset`.
  void exclude_cell(const Eigen::Vector2d& place_um);

  /// The latest hint in force no longer counts: cell or needle are searched for again without it. Nothing without one.
  void take_back_hint();

  const HintOutcomes& hint_outcomes() const noexcept;

  /// Forgets the cell, the needle, the holder, all hints and everything learnt.
  void reset();

  const TrackerOptions& options() const noexcept;

  /// Time spent on the parts of the last frame.
  const TrackerTimings& timings() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
