#pragma once
#include <vector>

#include "pellucida/core_vtk/FrameSource.h"

namespace pellucida {

/// The first 300 frames of a source. Throws NothingMeasuredError when it has none.
std::vector<Frame> read_frames(FrameSource& source);

/// Frames read before: handing one out costs nothing, where drawing or decoding it would take what is measured.
class MemorySource final : public FrameSource {
 public:
  /// `frames`: must outlive it.
  MemorySource(SourceInfo info, const std::vector<Frame>& frames) : info_(std::move(info)), frames_(frames) {}
  const SourceInfo& info() const noexcept override { return info_; }
  std::optional<Frame> next() override {
    return next_ < frames_.size() ? std::optional<Frame>(frames_[next_++]) : std::nullopt;
  }

 private:
  SourceInfo info_;
  const std::vector<Frame>& frames_;
  std::size_t next_ = 0;
};

}  // namespace pellucida
