#include "MemorySource.h"

#include "pellucida/core/Error.h"

namespace pellucida {

std::vector<Frame> read_frames(FrameSource& source) {
  constexpr std::size_t kMostFrames = 300;
  std::vector<Frame> frames;
  while (frames.size() < kMostFrames) {
    std::optional<Frame> frame = source.next();
    if (!frame) break;
    frames.push_back(std::move(*frame));
  }
  if (frames.empty()) throw NothingMeasuredError(source.info().name + ": it has no frames");
  return frames;
}

}  // namespace pellucida
