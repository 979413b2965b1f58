#pragma once
#include <string>

#include "pellucida/session/SessionInfo.h"
#include "pellucida/vtk_files/DataFile.h"
#include "pellucida/vtk_files/DataWriter.h"
#include "pellucida/vtk_files/SurfacePrecision.h"

namespace pellucida {

/// Makes the contents of a session's data files, one after another, in one layout.
class PartPacker {
 public:
  explicit PartPacker(SessionLayout layout) : wide_(layout == SessionLayout::kWide) {}

  std::string pack(SessionPart, vtkImageData* image, Packing packing) {
    return wide_ ? serialise(image, packing) : writer_.write(image, packing);
  }
  std::string pack(SessionPart part, vtkPolyData* data, Packing) {
    if (wide_) return serialise(data);
    return part == SessionPart::kSurface ? writer_.write(narrowed_surface(data).Get()) : writer_.write(data);
  }
  std::string pack_narrowed(vtkPolyData* surface, const PackedArrays* common) {
    return wide_ ? serialise(surface) : writer_.write(surface, common);
  }
  std::string pack_hand(vtkPolyData* block) { return wide_ ? serialise(block) : writer_.write(block); }

 private:
  const bool wide_;
  DataWriter writer_;
};

}  // namespace pellucida
