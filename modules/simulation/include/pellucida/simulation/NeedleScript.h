#pragma once
#include <vector>

#include "pellucida/simulation/Scenario.h"

namespace pellucida {

/// The needle's motion along its axis: approach, indentation, hold, retraction, with soft changes of speed. Depth is
/// the tip's distance past the resting membrane, um: negative outside.
class NeedleScript {
 public:
  /// `motion` as validated. The depth starts at -gap; the speeds change over `smoothing_s` (a moving average of the
  /// broken line of constant speeds), and the largest depth is reached exactly when the hold is at least that long.
  explicit NeedleScript(const Scenario::Motion& motion);

  double depth_um(double time_s) const;
  /// When the last move has ended.
  double duration_s() const noexcept { return end_s_; }

 private:
  double integral(double time_s) const;

  std::vector<double> time_s_, depth_um_, integral_;  // corners of the broken line, and its integral up to them
  double window_s_ = 0.0, end_s_ = 0.0;
};

}  // namespace pellucida
