#pragma once
#include <cstdint>
#include <deque>
#include <utility>

#include "pellucida/core_vtk/Scene.h"
#include "pellucida/pipeline/LiveRun.h"
#include "presenters/Phrase.h"

namespace pellucida {

/// Everything the status line says, UTF-8.
struct StatusTexts {
  Phrase frame_age;
  Phrase frame_rate;  ///< frames measured and drawn, a second
  Phrase lost;        ///< frames not measured, lost by the source, lost to the recorder
  Phrase recording;
  Phrase notice;  ///< one line: what went wrong, or the state of the run; may be empty
};

/// Turns a run's status and the scene shown into words. Knows no widgets; one thread.
class StatusPresenter {
 public:
  /// `scene`: the one shown; nullptr before the first measured one. `drawn_count`: scenes drawn so far. `now_s` is any
  /// monotonic clock, for the rates.
  StatusTexts update(const LiveStatus& status, const Scene* scene, bool paused, std::uint64_t drawn_count,
                     double now_s);

 private:
  // A count's rise per second over the last two; NaN before that is known.
  class Rate {
   public:
    double update(std::uint64_t count, double now_s);

   private:
    std::deque<std::pair<double, std::uint64_t>> counts_;  // (time, count)
  };

  Rate measured_;
  Rate drawn_;
};

}  // namespace pellucida
