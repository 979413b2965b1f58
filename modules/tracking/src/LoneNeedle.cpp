#include "LoneNeedle.h"

#include <algorithm>

#include "TrackerPace.h"

namespace pellucida {

void LoneNeedle::follow(const FrameInput& frame, SceneReader& reader, const GrayImage* whole) {
  const PartTimer timer(frame.timings->needle_us);
  if (!needle_.valid()) {
    if (start(frame, reader, whole)) learn_command(frame, true);
    return;
  }
  const NeedleCue cue{kNeedleReach_px, true, frame.command, {0.0, 0.0}, std::nullopt};
  const bool seen = needle_.is_read() ? needle_.follow_read(reader.tips(), frame.image, cue)
                                      : needle_.track(frame.image, frame.noise, cue);
  if (!seen && needle_.estimate().confidence < kLeastNeedleConfidence) needle_.reset();
  const bool is_asked = seen && frame.networks && !needle_.is_read();
  if (is_asked && (frame.reader != nullptr || !needle_.is_where_read(reader.tips(), frame.image)))
    needle_.read_tip(reader.tips(), frame.image, kLoneTipShare);
  if (seen) learn_command(frame, false);
}

void LoneNeedle::learn_command(const FrameInput& frame, bool is_new) const {
  const NeedleEstimate& n = needle_.estimate();
  if (frame.command && needle_.valid()) frame.command->learn(n.tip, n.direction, n.tip_sigma, is_new);
}

// The scene knows a needle from a holding pipette; lines may find one that it doesn't see.
bool LoneNeedle::start(const FrameInput& frame, SceneReader& reader, const GrayImage* whole) {
  const auto starts = [&](const SceneTool& seen) {
    const ExpectedTip expected = expected_tip(seen);
    if (!needle_.start(frame.image, found_tool(seen), frame.noise, &expected))
      return needle_.start_read(reader.tips(), frame.image, {seen.tip, seen.direction}, seen.half_width_px);
    needle_.read_tip(reader.tips(), frame.image, 1.0);
    return true;
  };
  const bool is_seen = frame.seen && std::any_of(frame.seen->needles.begin(), frame.seen->needles.end(), starts);
  const bool is_found = is_seen || (whole && needle_.start_anywhere(frame.image, *whole, frame.noise));
  if (!is_found) needle_.reset();
  return is_found;
}

}  // namespace pellucida
