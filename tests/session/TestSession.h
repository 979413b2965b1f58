#pragma once
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "Checksum.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionInfo.h"
#include "pellucida/session/SessionWriter.h"
#include "support/Files.h"

namespace pellucida::test {

namespace fs = std::filesystem;

inline std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Whether one of the lines contains `part`.
inline bool mentions(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const auto& line) { return line.find(part) != std::string::npos; });
}

/// The problem is found, a repair mends the session, and nothing is found after it.
inline void expect_mended(const fs::path& session, const std::string& problem) {
  const SessionReport found = check_session(session, false);
  EXPECT_FALSE(found.fine());
  EXPECT_TRUE(mentions(found.problems, problem)) << testing::PrintToString(found.problems);
  EXPECT_TRUE(found.repairs.empty());
  EXPECT_TRUE(check_session(session, true).repaired);
  const SessionReport after = check_session(session, false);
  EXPECT_TRUE(after.fine()) << testing::PrintToString(after.problems);
}

/// The lines of a table without the checksums at their ends.
inline std::vector<std::string> rows_of(const fs::path& table) {
  std::vector<std::string> lines = lines_of(table);
  for (std::string& line : lines) {
    const std::string_view row(line.data(), line.rfind(','));
    EXPECT_TRUE(&line == &lines.front() || signed_row(row) == line) << line;
    line.resize(row.size());
  }
  return lines;
}

/// A session as it was written before there were checksums.
inline void remove_checksums(const fs::path& session) {
  for (const char* table : {"measurements.csv", "events.csv"}) {
    std::string text;
    for (const std::string& row : rows_of(session / table)) text += row + '\n';
    put(session / table, text);
  }
  fs::remove(session / "checksums.csv");
  std::string head = text_of(session / "session.json");
  head.resize(head.rfind(",\n  \"crc32\""));
  put(session / "session.json", head + "\n}\n");
}

inline double time_of(long frame) {
  return static_cast<double>(frame) / 30.0;
}

/// A small cell, its numbers depending on the frame.
inline Observation make_observation(long frame) {
  Observation observation;
  observation.frame_index = frame;
  observation.time_s = time_of(frame);
  observation.state = CellState::kContact;
  observation.confidence = 0.75;
  const auto circle = [&](Membrane membrane, double radius_um, int count) {
    MembraneContour contour;
    contour.membrane = membrane;
    contour.points_um.resize(2, count);
    for (int i = 0; i < count; ++i) {
      const double angle_rad = 2.0 * M_PI * i / count;
      contour.points_um.col(i) << 100.0 + static_cast<double>(frame) + radius_um * std::cos(angle_rad),
          80.0 + radius_um * std::sin(angle_rad);
    }
    contour.sigma_um = Eigen::VectorXd::Constant(count, 0.125);
    return contour;
  };
  observation.outer = circle(Membrane::kOuter, 50.0, 12);
  observation.inner = circle(Membrane::kInner, 40.0, 10);
  observation.needle = NeedlePose{};
  observation.needle->outline_um.resize(2, 3);
  observation.needle->outline_um << 150.0, 160.0, 170.0, 80.0, 81.0, 82.0;
  observation.needle->tip_um << 150.0, 80.0;
  observation.center_um << 100.0, 80.0;
  observation.indentation_um = 3.0 * static_cast<double>(frame);
  return observation;
}

/// A tetrahedron with every array of the contract; node 0 carries the frame's number as its force along x.
inline vtkSmartPointer<vtkPolyData> make_surface(long frame) {
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto faces = vtkSmartPointer<vtkCellArray>::New();
  const double corners_um[4][3] = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
  for (const auto& corner_um : corners_um) points->InsertNextPoint(corner_um);
  for (const auto& face : {std::array<vtkIdType, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    faces->InsertNextCell(3, face.data());
  }
  surface->SetPoints(points);
  surface->SetPolys(faces);
  const auto add = [&](const char* name, int components, float scale) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(4);
    for (vtkIdType i = 0; i < 4; ++i) {
      for (int j = 0; j < components; ++j) {
        array->SetComponent(i, j, scale * static_cast<float>(frame + 10 * i + j));
      }
    }
    surface->GetPointData()->AddArray(array);
  };
  add(array_name::kForce, 3, 1.0F);
  add(array_name::kForceSigma, 1, 0.5F);
  add(array_name::kDisplacement, 3, 0.25F);
  add(array_name::kTension, 1, 2.0F);
  auto membrane = vtkSmartPointer<vtkIntArray>::New();
  membrane->SetName(array_name::kMembrane);
  for (const int value : {0, 0, 1, 1}) membrane->InsertNextValue(value);
  surface->GetPointData()->AddArray(membrane);
  stamp(surface, time_of(frame), frame);
  return surface;
}

/// A small image whose first pixel is the frame's number.
inline vtkSmartPointer<vtkImageData> make_image(long frame) {
  std::vector<std::uint8_t> pixels(6 * 4);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(frame + static_cast<long>(i));
  return make_frame({pixels.data(), PixelFormat::kGray8, 6, 4, 6, 0.825}, time_of(frame), frame);
}

/// A scene with all its parts.
inline Scene make_scene(long frame) {
  const Observation observation = make_observation(frame);
  Scene scene;
  scene.arrival_s = observation.time_s;
  scene.frame = Frozen(make_image(frame));
  scene.membranes = Frozen(make_membranes(observation));
  scene.tools = Frozen(make_tools(observation));
  scene.surface = Frozen(make_surface(frame));
  scene.measurement = measurement_from(observation);
  scene.measurement.contact_force_uN = 0.5 * static_cast<double>(frame);
  return scene;
}

/// A scene in which no cell was found: an image and a row.
inline Scene make_empty_scene(long frame) {
  Scene scene;
  scene.frame = Frozen(make_image(frame));
  scene.measurement.frame = frame;
  scene.measurement.time_s = time_of(frame);
  return scene;
}

inline SessionInfo make_info() {
  SessionInfo info;
  info.source.name = "a video.avi";
  info.source.width_px = 6;
  info.source.height_px = 4;
  info.source.pixel_size_um = 0.825;
  info.source.pixel_size_origin = "option";
  info.source.frame_rate_hz = 30.0;
  info.source.frame_rate_origin = "metadata";
  info.source.frame_count = 99;
  info.profile_name = "mouse-oocyte";
  info.profile_json = R"({"name":"mouse-oocyte","material":{"poisson_ratio":0.49}})";
  info.command_line = "pellucida analyze \"a video.avi\" --output s";
  info.seeds = {{"noise", 42}};
  info.clock_offsets_s = {{"camera", -0.25}};
  info.drop_policy = "newest wins";
  return info;
}

/// A closed session of frames 0 .. count-1.
inline void write_session(const fs::path& folder, long count) {
  SessionWriter writer(folder, make_info());
  for (long frame = 0; frame < count; ++frame) writer.write(make_scene(frame));
  writer.event({0.05, "contact", "needle, outer membrane"});
  writer.close();
}

}  // namespace pellucida::test
