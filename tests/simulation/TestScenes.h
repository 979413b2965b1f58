#pragma once
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/Scenario.h"

namespace pellucida::test {

inline Scenario scenario_of(const std::string& json) {
  return parse_scenario(json, "test");
}

/// Every byte of a frame's rows.
inline std::vector<std::uint8_t> bytes_of(const Frame& frame) {
  const ImageView view = view_of(frame.image.get());
  const auto* first = static_cast<const std::uint8_t*>(view.data);
  return {first, first + view.row_bytes * view.height_px};
}

/// One of the shipped reference cells, as a test's parameter.
struct ReferenceCase {
  const char* cell;
  int configuration;
};

inline void PrintTo(const ReferenceCase& reference, std::ostream* out) {
  *out << reference.cell << ' ' << reference.configuration;
}

}  // namespace pellucida::test
