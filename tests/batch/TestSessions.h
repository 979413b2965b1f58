#pragma once
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "pellucida/core/Event.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida::test {

/// A closed session of these forces, a frame each at 10 Hz and 2 um deeper; NaN: a frame without a force.
inline void write_session(const std::filesystem::path& folder, const std::vector<double>& forces_uN,
                          const std::vector<Event>& events = {}) {
  SessionInfo info;
  info.source.name = "test";
  info.source.width_px = info.source.height_px = 16;
  info.source.pixel_size_um = 1.0;
  info.source.frame_rate_hz = 10.0;
  SessionWriter writer(folder, info, {.frames = false});
  for (std::size_t i = 0; i < forces_uN.size(); ++i) {
    Scene scene;
    scene.measurement.frame = static_cast<long>(i);
    scene.measurement.time_s = 0.1 * static_cast<double>(i);
    scene.measurement.state = CellState::kContact;
    scene.measurement.contact_force_uN = forces_uN[i];
    scene.measurement.contact_force_lower_uN = 0.9 * forces_uN[i];
    scene.measurement.contact_force_upper_uN = 1.1 * forces_uN[i];
    scene.measurement.contact_force_picture_lower_uN = (1.0 - 1.96 * 0.05) * forces_uN[i];
    scene.measurement.contact_force_picture_upper_uN = (1.0 + 1.96 * 0.05) * forces_uN[i];
    scene.measurement.contact_force_scale_lower_uN = std::exp(-1.96 * 0.4) * forces_uN[i];
    scene.measurement.contact_force_scale_upper_uN = std::exp(1.96 * 0.4) * forces_uN[i];
    scene.measurement.indentation_um = 2.0 * static_cast<double>(i);
    scene.measurement.stiffness_uN_per_um = 0.25;
    writer.write(scene);
  }
  for (const Event& event : events) writer.event(event);
  writer.close();
}

}  // namespace pellucida::test
