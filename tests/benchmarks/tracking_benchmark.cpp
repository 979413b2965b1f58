// The tracker's cost a frame and a detection, on frames of the virtual microscope held in memory.
#include <benchmark/benchmark.h>

#include "GrayImage.h"
#include "HolderFinder.h"
#include "NeedleTracker.h"
#include "ToolFinder.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace {

using namespace pellucida;

const std::vector<Frame>& frames() {
  static const std::vector<Frame> kept = [] {
    const auto microscope = open_virtual("default");
    std::vector<Frame> all;
    while (auto frame = microscope->next()) all.push_back(std::move(*frame));
    return all;
  }();
  return kept;
}

// Warm: the cell is known, the frames follow one another.
void BM_Frame(benchmark::State& state) {
  MembraneTracker tracker;
  std::size_t k = 0;
  for (; k < 10; ++k) tracker.process(view_of(frames()[k].image.get()), frames()[k].time_s, 0);
  for (auto _ : state) {
    const Frame& f = frames()[k];
    benchmark::DoNotOptimize(tracker.process(view_of(f.image.get()), f.time_s, f.frame_index));
    if (++k < frames().size()) continue;
    state.PauseTiming();
    tracker.reset();
    for (k = 0; k < 10; ++k) tracker.process(view_of(frames()[k].image.get()), frames()[k].time_s, 0);
    state.ResumeTiming();
  }
}
BENCHMARK(BM_Frame)->Unit(benchmark::kMillisecond);

// Cold: the whole image is searched, contours, needle and holder are found.
void BM_Detection(benchmark::State& state) {
  MembraneTracker tracker;
  const Frame& f = frames().front();
  for (auto _ : state) {
    tracker.reset();
    benchmark::DoNotOptimize(tracker.process(view_of(f.image.get()), f.time_s, f.frame_index));
  }
}
BENCHMARK(BM_Detection)->Unit(benchmark::kMillisecond);

// The default scenario's cell, as its truth has it in frame 0, and the tools found round it.
contour::Circle first_cell() {
  const auto microscope = open_virtual("default");
  const Observation& truth = microscope->truth().observation;
  const double pixel_size_um = microscope->scenario().image.pixel_size_um;
  return {truth.center_um / pixel_size_um, truth.rest_outer_radius_um / pixel_size_um, 1.0, 0.0};
}

void BM_ToolSearch(benchmark::State& state) {
  const contour::Circle cell = first_cell();
  GrayImage gray;
  load(view_of(frames().front().image.get()), gray);
  for (auto _ : state) benchmark::DoNotOptimize(find_tools(gray, cell));
}
BENCHMARK(BM_ToolSearch)->Unit(benchmark::kMillisecond);

// No cell to go by: lines, guesses, and a start.
void BM_NeedleAnywhere(benchmark::State& state) {
  const FrameSampler image(view_of(frames().front().image.get()));
  GrayImage gray;
  load(view_of(frames().front().image.get()), gray);
  NeedleTracker needle;
  for (auto _ : state) benchmark::DoNotOptimize(needle.start_anywhere(image, gray, noise_level(image)));
}
BENCHMARK(BM_NeedleAnywhere)->Unit(benchmark::kMillisecond);

void BM_HolderSearch(benchmark::State& state) {
  const contour::Circle cell = first_cell();
  const FrameSampler image(view_of(frames().front().image.get()));
  GrayImage gray;
  load(view_of(frames().front().image.get()), gray);
  const std::vector<FoundTool> tools = find_tools(gray, cell);
  for (auto _ : state) benchmark::DoNotOptimize(find_holder(image, tools, cell, noise_level(image)));
}
BENCHMARK(BM_HolderSearch)->Unit(benchmark::kMillisecond);

// A needle followed: in the clear while its look is learnt (0), and in contact (1).
void BM_Needle(benchmark::State& state) {
  const contour::Circle cell = first_cell();
  const bool contact = state.range(0) == 1;
  const std::size_t first = contact ? 25 : 1, last = contact ? frames().size() : 12;
  GrayImage gray;
  load(view_of(frames().front().image.get()), gray);
  const std::vector<FoundTool> tools = find_tools(gray, cell);
  NeedleTracker needle;
  const auto begin = [&] {
    const FrameSampler image(view_of(frames().front().image.get()));
    for (const FoundTool& tool : tools)
      if (tool.half_width() < 0.2 * cell.radius && needle.start(image, tool, noise_level(image))) break;
    for (std::size_t k = 1; k < first; ++k) {
      const FrameSampler next(view_of(frames()[k].image.get()));
      needle.track(next, noise_level(next), {34.0, k < 12, {}});
    }
    return first;
  };
  std::size_t k = begin();
  if (!needle.valid()) return state.SkipWithError("the default scenario's needle was not found");
  for (auto _ : state) {
    const FrameSampler image(view_of(frames()[k].image.get()));
    benchmark::DoNotOptimize(needle.track(image, 0.01, {34.0, !contact, {}}));
    if (++k < last) continue;
    state.PauseTiming();
    k = begin();
    state.ResumeTiming();
  }
}
BENCHMARK(BM_Needle)->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace
