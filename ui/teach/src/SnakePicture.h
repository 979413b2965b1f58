#pragma once
#include <memory>
#include <string>

#include "pellucida/core/Step.h"
#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/teaching/SnakeField.h"

namespace pellucida {

/// Which frame a snake is to see, and how.
struct SnakePictureOrder {
  std::string source;   ///< `virtual:SCENARIO`, a session's folder, or a file that `open_any_source` reads
  double time_s = 0.0;  ///< the first frame of this time or later; past the end the last one
  double blur_px = 1.0;
  std::string attraction = "dark-lines";

  bool operator==(const SnakePictureOrder&) const = default;
};

/// The frame and what it is to a snake.
struct SnakePicture {
  SnakePictureOrder order;
  Frozen<vtkImageData> image;
  double pixel_size_um = 0.0;
  double duration_s = 0.0;  ///< of what the frame was taken from; 0: not known
  std::shared_ptr<const SnakeField> field;
  std::string fault;  ///< why there is no picture; empty otherwise
};
using SnakePicturePtr = std::shared_ptr<const SnakePicture>;

/// Reads pictures. The frame is kept while only blur or attraction change. Takes up to a second: for a thread of its
/// own (`Stage`).
class SnakePictureStep {
 public:
  using Input = SnakePictureOrder;
  using Output = SnakePicturePtr;
  expected<Output, StepFailure> process(const Input& order);

 private:
  void read_frame(const SnakePictureOrder& order);

  SnakePictureOrder read_;
  Frozen<vtkImageData> image_;
  double pixel_size_um_ = 0.0;
  double duration_s_ = 0.0;
};

}  // namespace pellucida
