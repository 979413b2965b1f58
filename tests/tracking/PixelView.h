#pragma once
#include <cstdint>
#include <vector>

#include "pellucida/core/ImageView.h"

namespace pellucida::test {

/// An 8-bit picture as an image; `pixels` (width x height, row by row) has to outlive it.
inline ImageView view_of_bytes(const std::vector<std::uint8_t>& pixels, int width_px, int height_px,
                               double pixel_size_um) {
  ImageView view;
  view.data = pixels.data();
  view.width_px = width_px;
  view.height_px = height_px;
  view.row_bytes = width_px;
  view.pixel_size_um = pixel_size_um;
  return view;
}

}  // namespace pellucida::test
