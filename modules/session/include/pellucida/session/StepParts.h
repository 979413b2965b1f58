#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "pellucida/core/Measurement.h"
#include "pellucida/core_vtk/Frozen.h"
#include "pellucida/session/SessionInfo.h"
#include "pellucida/vtk_files/DataWriter.h"

namespace pellucida {

/// The content of a part's file. Any thread may read it.
struct PackedPart {
  std::string content;
  std::uint32_t crc32 = 0;
};

/// Parts of a step that were made ready elsewhere, in place of those of its scene; empty ones are the scene's.
struct StepParts {
  std::shared_ptr<const PackedPart> membranes;
  std::shared_ptr<const PackedPart> tools;
  vtkSmartPointer<vtkPolyData> surface;                ///< narrowed already (`narrowed_surface`)
  std::shared_ptr<const PackedArrays> surface_arrays;  ///< of its arrays, those that several sessions have in common
};

/// Packs what several sessions have in common, once for all of them, as `SessionWriter` packs it for one. One thread at
/// a time.
class CommonPacker {
 public:
  /// The file of `part` in the step of `row`; empty for an empty handle. Not for images.
  std::shared_ptr<const PackedPart> pack(SessionPart part, const Frozen<vtkPolyData>& data, const Measurement& row);
  /// The arrays of a narrowed surface.
  std::shared_ptr<const PackedArrays> pack_arrays(const Frozen<vtkPolyData>& surface);

 private:
  DataWriter writer_;
};

}  // namespace pellucida
