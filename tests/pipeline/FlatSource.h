#pragma once
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#include "pellucida/core/Clock.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida::test {

/// A camera over an empty dish: flat grey frames, as many and as fast as asked. May break after some.
class FlatSource : public FrameSource {
 public:
  FlatSource(long frame_count, double frame_rate_hz, long break_after = -1)
      : frame_count_(frame_count), break_after_(break_after), pixels_(64 * 48, 128) {
    info_.name = "flat";
    info_.width_px = 64;
    info_.height_px = 48;
    info_.pixel_size_um = 1.0;
    info_.pixel_size_origin = "scenario";
    info_.frame_rate_hz = frame_rate_hz;
    info_.frame_rate_origin = "scenario";
    info_.frame_count = frame_count;
  }

  const SourceInfo& info() const noexcept override { return info_; }

  std::optional<Frame> next() override {
    if (next_ == break_after_) throw InputError("flat: broken after frame " + std::to_string(next_ - 1));
    if (next_ >= frame_count_) return std::nullopt;
    Frame frame;
    frame.frame_index = next_;
    frame.time_s = static_cast<double>(next_) / info_.frame_rate_hz;
    frame.gap_count = next_ == 3 ? 1 : 0;
    frame.image = Frozen<vtkImageData>(make_frame({.data = pixels_.data(),
                                                   .format = PixelFormat::kGray8,
                                                   .width_px = 64,
                                                   .height_px = 48,
                                                   .row_bytes = 64,
                                                   .pixel_size_um = 1.0},
                                                  frame.time_s, frame.frame_index));
    ++next_;
    return frame;
  }

  bool restart() override {
    next_ = 0;
    return true;
  }

 protected:
  long next_ = 0;
  SourceInfo info_;

 private:
  long frame_count_;
  long break_after_;
  std::vector<std::uint8_t> pixels_;
};

/// A camera over an empty dish: a frame comes when its time has come, whether or not anybody asks for it.
class WallClockSource : public FlatSource {
 public:
  explicit WallClockSource(double frame_rate_hz) : FlatSource(1'000'000, frame_rate_hz), rate_hz_(frame_rate_hz) {
    info_.live = true;
    info_.frame_count.reset();
  }

  std::optional<Frame> next() override {
    const auto due = static_cast<long>(clock_.now_s() * rate_hz_);
    const long missed = std::max(0L, due - next_);
    next_ += missed;
    std::this_thread::sleep_for(std::chrono::duration<double>(static_cast<double>(next_) / rate_hz_ - clock_.now_s()));
    auto frame = FlatSource::next();
    frame->gap_count = missed;
    return frame;
  }

  bool restart() override { return false; }

 private:
  const double rate_hz_;
  const SteadyClock clock_;
};

}  // namespace pellucida::test
