#pragma once
#include <string_view>
#include <vector>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida::test {

/// A scenario's frames in memory, given out forth and back without end: no frame is far from its predecessor.
class FrameLoop {
 public:
  explicit FrameLoop(const Scenario& scenario) {
    VirtualMicroscope microscope(scenario);
    while (std::optional<Frame> frame = microscope.next()) frames_.push_back(std::move(*frame));
  }
  std::size_t size() const { return frames_.size(); }
  ImageView view(std::size_t k) const {
    const std::size_t last = frames_.size() - 1, place = last == 0 ? 0 : k % (2 * last);
    return view_of(frames_[place <= last ? place : 2 * last - place].image.get());
  }

 private:
  std::vector<Frame> frames_;
};

}  // namespace pellucida::test
