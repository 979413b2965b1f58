#pragma once
#include <vtkDataObject.h>
#include <vtkFieldData.h>

#include <cmath>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {

/// Stamps a part of a step where it isn't stamped so already: its time up to `tolerance_s`.
inline void stamp_as(vtkDataObject* data, double time_s, long frame_index, double tolerance_s) {
  vtkFieldData* field = data->GetFieldData();
  const bool is_stamped = field->GetArray(array_name::kTime) && field->GetArray(array_name::kFrameIndex) &&
                          field->GetArray(array_name::kSchemaVersion) &&
                          std::abs(stamped_time_s(data) - time_s) <= tolerance_s &&
                          stamped_frame_index(data) == frame_index;
  if (!is_stamped) stamp(data, time_s, frame_index);
}

}  // namespace pellucida
