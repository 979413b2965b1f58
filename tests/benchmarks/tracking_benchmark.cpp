// The tracker's cost a frame and a detection, on frames of the virtual microscope held in memory.
#include <benchmark/benchmark.h>

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

}  // namespace
