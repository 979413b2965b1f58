#include "pellucida/session/StepParts.h"

#include "Checksum.h"
#include "SessionFolder.h"
#include "StepStamp.h"
#include "pellucida/vtk_files/SurfacePrecision.h"

namespace pellucida {

std::shared_ptr<const PackedPart> CommonPacker::pack(SessionPart part, const Frozen<vtkPolyData>& data,
                                                     const Measurement& row) {
  auto copy = data.shallow_copy();
  if (!copy) return nullptr;
  stamp_as(copy, row.time_s, row.frame, 0.0);
  PackedPart packed;
  packed.content = writer_.write(part == SessionPart::kSurface ? narrowed_surface(copy) : copy);
  packed.crc32 = crc32_of(packed.content);
  return std::make_shared<const PackedPart>(std::move(packed));
}

std::shared_ptr<const PackedArrays> CommonPacker::pack_arrays(const Frozen<vtkPolyData>& surface) {
  const auto copy = surface.shallow_copy();
  return copy ? std::make_shared<const PackedArrays>(writer_.pack(copy)) : nullptr;
}

}  // namespace pellucida
