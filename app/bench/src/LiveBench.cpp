#include "pellucida/bench/LiveBench.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <thread>

#include "MemorySource.h"
#include "pellucida/core/Clock.h"
#include "pellucida/pipeline/LiveRun.h"

namespace pellucida {

LiveFigures measure_live(FrameSource& source, const PipelineOptions& options, double seconds) {
  constexpr auto kLook = std::chrono::milliseconds(50);
  constexpr std::uint64_t kLeastFrames = 20;  // some beyond the search
  const std::vector<Frame> frames = read_frames(source);
  LiveFigures figures;
  const SteadyClock clock;
  while (clock.now_s() < seconds) {
    LiveRun run(std::make_unique<MemorySource>(source.info(), frames), options);
    run.start();
    for (LiveStatus now = run.status(); !now.finished && (clock.now_s() < seconds || now.measured_count < kLeastFrames);
         now = run.status()) {
      std::this_thread::sleep_for(kLook);
    }
    run.stop();
    const auto rows = run.measurements_since(0);
    if (!rows.empty()) {
      const double found_s = rows.front().time_s + 1e-3 * rows.front().frame_age_ms;
      for (const Measurement& row : rows) {
        (row.time_s < found_s ? figures.search_us : figures.frame_to_force_us).add(1e3 * row.frame_age_ms);
      }
    }
    figures.skipped_count += static_cast<long>(run.status().skipped_count);
  }
  return figures;
}

}  // namespace pellucida
