#include "pellucida/pipeline/SessionBench.h"

#include <malloc.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "Recorder.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/pipeline/Distribution.h"
#include "pellucida/session/GeneratedSession.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/session/SessionWriter.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;
using BenchJson = nlohmann::ordered_json;

constexpr std::array kLayouts{SessionLayout::kWide, SessionLayout::kCompact};
constexpr std::array kPartFolders{"surface", "membranes", "tools", "frames"};
constexpr double kHandBlock_s = 1.0;
constexpr int kTicksPerBlock = 1000;

const char* name_of(SessionLayout layout) {
  return layout == SessionLayout::kWide ? "wide (before)" : "compact";
}

template <class... Args>
std::string line(const char* format, Args... args) {
  char text[256];
  std::snprintf(text, sizeof text, format, args...);
  return text;
}

// A number of /proc/self/status in MB: VmRSS, VmHWM.
double memory_MB(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0.0;
    if (word == key + ":" && status >> kilobytes) return 1.024e-3 * kilobytes;
  }
  return 0.0;
}

// Of all threads: what a busy machine does not stretch.
double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// From here on VmHWM is the largest since now.
void forget_largest_memory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

double raw_bytes(const Scene& scene) {
  vtkImageData* image = const_cast<vtkImageData*>(scene.frame.get());
  return image ? static_cast<double>(image->GetNumberOfPoints()) * image->GetScalarSize() : 0.0;
}

double folder_bytes(const fs::path& folder) {
  double bytes = 0.0;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) bytes += static_cast<double>(entry.file_size(none));
  return bytes;
}

BenchJson measure_writing(const std::vector<Scene>& scenes, const SourceInfo& source, SessionLayout layout,
                          std::string& text) {
  const TemporaryFolder folder;
  const fs::path session = folder / "session";
  SessionInfo info;
  info.source = source;
  const auto count = static_cast<double>(scenes.size());
  const double before_s = processor_s();
  const SteadyClock clock;
  SessionWriter writer(session, info, {.frames = true, .layout = layout, .rewritten = {}});
  for (const Scene& scene : scenes) writer.write(scene);
  writer.close();
  const double frames_per_s = count / clock.now_s();
  const double processor_ms = 1e3 * (processor_s() - before_s) / count;
  const double bytes = static_cast<double>(writer.counts().byte_count) / count;
  double raw = 0.0;
  for (const Scene& scene : scenes) raw += raw_bytes(scene) / count;
  text += line("writing, %-20s %9.1f frames/s (%.2f ms of processor each); %.1f kB a frame, %.3f of the raw image\n",
               name_of(layout), frames_per_s, processor_ms, 1e-3 * bytes, raw > 0.0 ? bytes / raw : 0.0);
  BenchJson parts;
  text += "  of that";
  for (const char* part : kPartFolders) {
    parts[part] = folder_bytes(session / part) / count;
    text += line(", %s %.1f kB", part, 1e-3 * parts[part].get<double>());
  }
  text += '\n';
  return {{"frames_per_s", frames_per_s},
          {"processor_ms", processor_ms},
          {"bytes_per_frame", bytes},
          {"bytes_per_frame_by_part", parts},
          {"raw_image_ratio", raw > 0.0 ? bytes / raw : 0.0}};
}

BenchJson measure_hour(const std::vector<Scene>& scenes, const SourceInfo& source, SessionLayout layout,
                       std::string& text) {
  const TemporaryFolder folder;
  const fs::path session = folder / "session";
  SessionInfo info;
  info.source = source;
  const GeneratedSession hour{.layout = layout};
  generate_session(session, info, scenes, hour);

  forget_largest_memory();
  const double before_MB = memory_MB("VmRSS");
  const double open_before_s = processor_s();
  const SteadyClock open_clock;
  const SessionReader reader(session);
  const double open_s = open_clock.now_s();
  const double open_processor_s = processor_s() - open_before_s;
  const double memory = std::max(0.0, memory_MB("VmHWM") - before_MB);

  Distribution seek_ms;
  const double seek_before_s = processor_s();
  const long whole_count = hour.step_count / hour.whole_every;
  for (long i = 0; i < whole_count; ++i) {
    // Far from one to the next.
    const auto step = static_cast<std::size_t>((i * 37) % whole_count * hour.whole_every);
    const SteadyClock seek_clock;
    reader.load(step);
    seek_ms.add(1e3 * seek_clock.now_s());
  }
  const double seek_processor_ms = 1e3 * (processor_s() - seek_before_s) / static_cast<double>(whole_count);
  text += line(
      "an hour, %-20s %9.2f s to open %zu steps (%.2f s of processor), %.0f MB; seek %.1f ms median, %.1f ms at most "
      "(%.1f ms of processor)\n",
      name_of(layout), open_s, reader.steps().size(), open_processor_s, memory, seek_ms.quantile(0.5), seek_ms.max(),
      seek_processor_ms);
  return {{"steps", reader.steps().size()},        {"open_s", open_s},
          {"open_processor_s", open_processor_s},  {"open_MB", memory},
          {"seek_ms_p50", seek_ms.quantile(0.5)},  {"seek_ms_max", seek_ms.max()},
          {"seek_processor_ms", seek_processor_ms}};
}

// A second of a hand at 1 kHz, with arrays as many and as wide as a recorded one has.
Frozen<vtkPolyData> hand_block(double from_s) {
  vtkNew<vtkPolyData> block;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> paths;
  vtkNew<vtkDoubleArray> times;
  times->SetName(array_name::kTime);
  std::vector<vtkSmartPointer<vtkFloatArray>> arrays;
  for (const char* name : {"velocity_um_per_s", "hand_m", "force_N", "guide_force_N", "contact_force_uN"}) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    arrays.push_back(array);
  }
  for (int path = 0; path < 2; ++path) {
    paths->InsertNextCell(kTicksPerBlock);
    for (int tick = 0; tick < kTicksPerBlock; ++tick) {
      const double time_s = from_s + kHandBlock_s * tick / kTicksPerBlock;
      paths->InsertCellPoint(points->InsertNextPoint(100.0 + 9.0 * std::sin(3.1 * time_s + path), 80.0 * time_s, 0.0));
      times->InsertNextValue(time_s);
      for (std::size_t i = 0; i < arrays.size(); ++i) {
        const double phase = time_s * (2.0 + static_cast<double>(i));
        arrays[i]->InsertNextTuple3(std::sin(phase), std::cos(phase), std::sin(17.0 * phase));
      }
    }
  }
  block->SetPoints(points);
  block->SetLines(paths);
  block->GetPointData()->AddArray(times);
  for (const auto& array : arrays) block->GetPointData()->AddArray(array);
  return Frozen<vtkPolyData>(block.Get());
}

// The image again and again, mirrored from one time to the next, until the size is filled.
Frozen<vtkImageData> enlarged(const Frozen<vtkImageData>& image, int width_px, int height_px, long frame) {
  const ImageView small = view_of(image.get());
  const std::size_t bytes = small.format == PixelFormat::kGray16 ? 2 : 1;
  std::vector<std::uint8_t> pixels(bytes * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px));
  const auto mirrored = [](int i, int n) { return (i / n) % 2 == 0 ? i % n : n - 1 - i % n; };
  std::uint8_t* target = pixels.data();
  for (int y = 0; y < height_px; ++y) {
    const auto* row = static_cast<const std::uint8_t*>(small.data) + mirrored(y, small.height_px) * small.row_bytes;
    for (int x = 0; x < width_px; ++x) {
      const std::uint8_t* pixel = row + bytes * static_cast<std::size_t>(mirrored(x, small.width_px));
      target = std::copy(pixel, pixel + bytes, target);
    }
  }
  ImageView view = small;
  view.data = pixels.data();
  view.width_px = width_px;
  view.height_px = height_px;
  view.row_bytes = static_cast<std::ptrdiff_t>(bytes) * width_px;
  return Frozen<vtkImageData>(make_frame(view, 0.0, frame));
}

std::vector<Scene> enlarged(const std::vector<Scene>& scenes, int width_px, int height_px) {
  constexpr std::size_t kMost = 50;
  std::vector<Scene> large(scenes.begin(), scenes.begin() + static_cast<long>(std::min(kMost, scenes.size())));
  for (Scene& scene : large) {
    if (scene.frame) scene.frame = enlarged(scene.frame, width_px, height_px, scene.measurement.frame);
  }
  return large;
}

BenchJson measure_recording(const std::vector<Scene>& scenes, const SourceInfo& source, double rate_hz, double seconds,
                            std::string& text) {
  const TemporaryFolder folder;
  SessionInfo info;
  info.source = source;
  const ImageView size = view_of(scenes.front().frame.get());
  info.source.width_px = size.width_px;
  info.source.height_px = size.height_px;
  info.source.pixel_size_um = size.pixel_size_um;
  const double before_s = processor_s();
  const SteadyClock clock;
  Recorder recorder(folder / "session", info, clock);
  const auto count = static_cast<long>(rate_hz * seconds);
  double largest_waiting_MB = 0.0;
  double next_hand_s = 0.0;
  const auto start = std::chrono::steady_clock::now();
  for (long frame = 0; frame < count; ++frame) {
    const double time_s = static_cast<double>(frame) / rate_hz;
    std::this_thread::sleep_until(
        start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(time_s)));
    Scene scene = scenes[static_cast<std::size_t>(frame) % scenes.size()];
    scene.events.clear();
    scene.measurement.frame = frame;
    scene.measurement.time_s = time_s;
    Scene arrived;
    arrived.frame = scene.frame;
    arrived.measurement.frame = frame;
    arrived.measurement.time_s = time_s;
    recorder.announce(arrived);
    recorder.settle(scene);
    if (time_s >= next_hand_s) {
      recorder.hand(hand_block(time_s), time_s);
      next_hand_s += kHandBlock_s;
    }
    largest_waiting_MB = std::max(largest_waiting_MB, 1e-6 * static_cast<double>(recorder.waiting_bytes()));
  }
  const double fed_s = clock.now_s();
  recorder.close();
  const double behind_s = clock.now_s() - fed_s;
  const double processor_ms = 1e3 * (processor_s() - before_s) / static_cast<double>(count);
  text += line(
      "recording %4d x %-4d, %3.0f Hz   %9llu frames in %.1f s, %llu without image, %llu without surface; at most "
      "%.0f MB waited, closed %.2f s later; %.2f ms of processor a frame\n",
      size.width_px, size.height_px, rate_hz, static_cast<unsigned long long>(recorder.written_count()), fed_s,
      static_cast<unsigned long long>(recorder.dropped_count()),
      static_cast<unsigned long long>(recorder.thinned_count()), largest_waiting_MB, behind_s, processor_ms);
  return {{"width_px", size.width_px},
          {"height_px", size.height_px},
          {"rate_hz", rate_hz},
          {"seconds", fed_s},
          {"written", recorder.written_count()},
          {"without_image", recorder.dropped_count()},
          {"without_surface", recorder.thinned_count()},
          {"largest_waiting_MB", largest_waiting_MB},
          {"closed_after_s", behind_s},
          {"processor_ms", processor_ms}};
}

}  // namespace

SessionBenchReport measure_sessions(const std::vector<Scene>& scenes, const SourceInfo& source, double seconds) {
  constexpr int kLargeWidth_px = 1280, kLargeHeight_px = 1024;
  SessionBenchReport report;
  BenchJson json;
  for (const SessionLayout layout : kLayouts) {
    BenchJson& one = json[layout == SessionLayout::kWide ? "wide" : "compact"];
    one["writing"] = measure_writing(scenes, source, layout, report.text);
  }
  for (const SessionLayout layout : kLayouts) {
    BenchJson& one = json[layout == SessionLayout::kWide ? "wide" : "compact"];
    one["hour"] = measure_hour(scenes, source, layout, report.text);
  }
  if (scenes.front().frame) {
    json["recording"].push_back(measure_recording(scenes, source, 100.0, seconds, report.text));
    json["recording"].push_back(
        measure_recording(enlarged(scenes, kLargeWidth_px, kLargeHeight_px), source, 50.0, seconds, report.text));
  }
  report.json = json.dump();
  return report;
}

}  // namespace pellucida
