#include "pellucida/bench/TrackingBench.h"

#include <vector>

#include "MemorySource.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida {
TrackingFigures measure_tracking(FrameSource& source, double seconds) {
  const std::vector<Frame> frames = read_frames(source);
  TrackingFigures figures;

  // Cold: every frame is a first one.
  const SteadyClock whole;
  MembraneTracker tracker;
  while (figures.detect_us.count() < 5 || whole.now_s() < 0.2 * seconds) {
    tracker.reset();
    const SteadyClock clock;
    tracker.process(view_of(frames.front().image.get()), 0.0, 0);
    figures.detect_us.add(1e6 * clock.now_s());
  }

  // Warm: forth and back, so that no frame is far from its predecessor. The first way there is not counted.
  const std::size_t last = frames.size() - 1;
  const double step_s = source.info().frame_rate_hz > 0.0 ? 1.0 / source.info().frame_rate_hz : 1.0 / 30.0;
  double elapsed_s = 0.0;
  for (std::size_t k = 1; elapsed_s < 0.8 * seconds || k <= 2 * frames.size(); ++k) {
    const std::size_t place = last == 0 ? 0 : k % (2 * last);
    const Frame& frame = frames[place <= last ? place : 2 * last - place];
    const SteadyClock clock;
    tracker.process(view_of(frame.image.get()), static_cast<double>(k) * step_s, static_cast<long>(k));
    const double frame_s = clock.now_s();
    if (k <= last) continue;
    elapsed_s += frame_s;
    figures.frame_us.add(1e6 * frame_s);
    const TrackerTimings& t = tracker.timings();
    figures.parts_us["needle"].add(t.needle_us);
    figures.parts_us["rigid"].add(t.rigid_us);
    figures.parts_us["contours"].add(t.contours_us);
    figures.parts_us["report"].add(t.report_us);
  }
  figures.frames_per_s = static_cast<double>(figures.frame_us.count()) / elapsed_s;
  return figures;
}

}  // namespace pellucida
