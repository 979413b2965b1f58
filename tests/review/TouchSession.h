#pragma once
#include <filesystem>
#include <string>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionWriter.h"
#include "visualization/SyntheticScene.h"

namespace pellucida::test {

inline constexpr long kFrames = 30;
inline constexpr double kStep_s = 0.1;

inline double indentation_of(long frame) {
  return frame < 5 ? 0.0 : 0.8 * static_cast<double>(frame - 4);
}

/// Thirty frames, ten a second: five free, and so many more where the touch is late, then a touch that goes deeper.
inline void write_touch(const std::filesystem::path& folder, bool close = true, long late_frames = 0,
                        const std::string& profile_json = {}) {
  SessionInfo info;
  info.source.name = "synthetic";
  info.source.width_px = 728;
  info.source.height_px = 486;
  info.source.pixel_size_um = 0.825;
  info.source.pixel_size_origin = "scenario";
  info.source.frame_rate_hz = 1.0 / kStep_s;
  info.source.frame_rate_origin = "scenario";
  info.profile_name = "mouse-oocyte";
  info.profile_json = profile_json;
  SessionWriter writer(folder, info);
  for (long frame = 0; frame < kFrames; ++frame) {
    Scene scene = synthetic_scene(indentation_of(frame - late_frames), frame);
    scene.measurement.frame = frame;
    scene.measurement.time_s = kStep_s * static_cast<double>(frame);
    scene.measurement.state = frame < 5 + late_frames ? CellState::kFree : CellState::kContact;
    for (auto* part : {&scene.membranes, &scene.tools, &scene.surface}) {
      auto own = vtkSmartPointer<vtkPolyData>::New();
      own->DeepCopy(part->shallow_copy());
      stamp(own, scene.measurement.time_s, frame);
      *part = Frozen<vtkPolyData>(own);
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->DeepCopy(scene.frame.shallow_copy());
    stamp(image, scene.measurement.time_s, frame);
    scene.frame = Frozen<vtkImageData>(image);
    writer.write(scene);
  }
  writer.event({0.5, "contact", "first touch"});
  writer.event({2.0, "note", "<b>bold</b>"});
  if (close) writer.close();
}

}  // namespace pellucida::test
