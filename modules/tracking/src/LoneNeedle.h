#pragma once
#include <utility>

#include "CellFollower.h"
#include "GrayImage.h"
#include "SceneReader.h"

namespace pellucida {

/// The needle while no cell is in view: looked for where a cell is, followed alone until one is found.
class LoneNeedle {
 public:
  /// Follows the one there is, or else looks for one: among those of the scene, where that was read in this frame, and
  /// by lines alone in `whole`, the same image; null: not by lines. The commanded motion learns from it.
  void follow(const FrameInput& frame, SceneReader& reader, const GrayImage* whole);
  /// Goes on with one that was found otherwise.
  void take(NeedleTracker needle) { needle_ = std::move(needle); }
  void reset() noexcept { needle_.reset(); }
  bool valid() const noexcept { return needle_.valid(); }
  const NeedleEstimate& estimate() const noexcept { return needle_.estimate(); }

 private:
  bool start(const FrameInput& frame, SceneReader& reader, const GrayImage* whole);
  void learn_command(const FrameInput& frame, bool is_new) const;

  NeedleTracker needle_;
};

}  // namespace pellucida
