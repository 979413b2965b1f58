#pragma once
#include <string>
#include <vector>

#include "pellucida/core_vtk/Scene.h"

namespace pellucida {

/// Figures of recording, as text for a person and as JSON.
struct SessionBenchReport {
  std::string text;
  std::string json;
};

/// What sessions cost, the layout before beside the one of today, on the disk of TMPDIR:
/// - writing `scenes` one after another: rate, bytes a frame and a part against the raw image;
/// - opening a generated hour at 30 frames/s (108,000 rows): time, memory, time to seek; its files are in the system's
///   cache;
/// - recording live, by a `Recorder`: `scenes` at 100 frames/s with a 1 kHz hand, then images of 1280 x 1024 with the
/// same
///   surfaces at 50 frames/s, each for `seconds`: what was left out.
/// `scenes` are measured ones of `source`, at least one. Throws OutputError when the disk refuses.
SessionBenchReport measure_sessions(const std::vector<Scene>& scenes, const SourceInfo& source, double seconds);

}  // namespace pellucida
