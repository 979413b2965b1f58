#pragma once
#include <cstdint>
#include <memory>

#include "pellucida/core/ImageView.h"
#include "pellucida/microscopy/Look.h"
#include "pellucida/microscopy/MicroscopeScene.h"

namespace pellucida {

/// Draws a scene by its optical path: phi(x, y) = 2 pi / lambda times the index difference times the thickness, summed
/// along z, lambda 0.55 um. The cell is a body of revolution about the needle's line; each side of its section is
/// revolved by itself. A contrast turns phi into light, a camera light into grey values. One thread at a time.
class OpticalRenderer {
 public:
  /// `image` gives size, format and pixel size (its data are not used); `cell_radius_um` the cell's at rest, for what
  /// lies in it. `seed`: of everything random. Throws UsageError: JPEG with 16 bit.
  OpticalRenderer(const Look& look, const ImageView& image, double cell_radius_um, std::uint64_t seed);
  ~OpticalRenderer();

  /// The frame, valid until the next call. Deterministic: the same look, scene and seed give the same bytes; with
  /// `camera.interlaced` also the same scene before.
  ImageView render(const MicroscopeScene& scene);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
