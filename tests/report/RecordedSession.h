#pragma once
#include <filesystem>
#include <string>

#include "SphereSurface.h"
#include "SyntheticRows.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida::test {

/// What a source and a person may write into a session.
inline constexpr const char* kHostileName = "dish <script>alert(\"1\")</script> & co.avi";

/// `rows` as a session on the disk; rows in contact have a surface, grown by `growth`, with a tension of 0.4 uN/um.
inline void write_session(const std::filesystem::path& folder, const SyntheticRows& rows, double growth = 1.02,
                          const SessionInfo& given = {}) {
  SessionInfo info = given;
  info.source.name = kHostileName;
  info.source.width_px = 728;
  info.source.height_px = 486;
  info.source.pixel_size_um = 0.825;
  info.source.pixel_size_origin = "option";
  info.source.frame_rate_hz = 30.0;
  info.profile_name = "mouse-oocyte";
  info.profile_json = R"({"name":"mouse-oocyte"})";
  info.provenance_json = R"({"versions":{"VTK":"9.1.0"},"inputs_sha256":{"profile":"00ff"}})";
  SessionWriter writer(folder, info);
  for (const Event& event : rows.events()) writer.event(event);
  for (const Measurement& row : rows.rows()) {
    Scene scene;
    scene.measurement = row;
    scene.arrival_s = row.time_s;
    if (row.state == CellState::kContact) {
      auto surface = sphere_surface(50.0, growth);
      add_tension(surface, 0.4, 0.9);
      stamp(surface, row.time_s, row.frame);
      scene.surface = Frozen(surface);
    }
    writer.write(scene);
  }
  writer.close();
}

}  // namespace pellucida::test
