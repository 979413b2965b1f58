#pragma once
#include <vtkImageData.h>

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>

#include "pellucida/core/CameraExposure.h"
#include "pellucida/core/SourceInfo.h"
#include "pellucida/core_vtk/Frozen.h"

namespace pellucida {

/// How far a frame goes through the chain. A recording of a live run repeats what time allowed then.
enum class FrameUse : int {
  kKeep = 0,     ///< its image alone
  kTrack = 1,    ///< contours and tools
  kRevolve = 2,  ///< and the surface
  kMeasure = 3   ///< and the force: everything
};

/// What a decoder could not read of a frame, or only by making up for what was missing.
struct FrameDamage {
  bool damaged = false;   ///< its pixels, or those of a frame that it needs, are not what was recorded
  long count_before = 0;  ///< damaged frames in a row right before it
  std::string reason;     ///< in the decoder's words; empty for none
};

/// One frame as delivered by a source.
struct Frame {
  Frozen<vtkImageData> image;  ///< 1 component, 8 or 16 bit unsigned, spacing in um, stamped
  double time_s = 0.0;         ///< since the source's first frame, from the source's own clock or frame rate
  long frame_index = 0;        ///< counts the source's frames, lost ones included
  long gap_count = 0;          ///< frames lost between the one before and this one
  long run_index = 0;          ///< increases where the frames begin anew: steps with memory then reset
  FrameUse use = FrameUse::kMeasure;
  FrameDamage damage;  ///< a damaged frame is kept, not measured
  /// Where a manipulator reported the needle's tip at this frame's time, frame W, um; nothing where none moves it.
  std::optional<Eigen::Vector2d> manipulator_um;
};

/// Anything that delivers frames: video, folder, multi-page TIFF, still, camera, virtual microscope. Used by one thread
/// at a time.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  virtual const SourceInfo& info() const noexcept = 0;

  /// The next frame; blocks for it. Nothing at the end. Throws InputError when the input turns out to be damaged
  /// (everything before remains valid), DeviceError when a camera is lost.
  virtual std::optional<Frame> next() = 0;

  /// Restarts: `next()` delivers the first frame again. False if this kind of source can't.
  virtual bool restart() { return false; }

  /// The camera's exposure, for any thread, also after the source is gone; nullptr where it can't be set.
  virtual std::shared_ptr<CameraExposure> exposure() { return nullptr; }
};

}  // namespace pellucida
