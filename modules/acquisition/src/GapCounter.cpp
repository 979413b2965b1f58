#include "GapCounter.h"

#include <algorithm>
#include <cmath>

namespace pellucida {

GapCounter::Place GapCounter::add(double time_s) {
  // The first frame has nothing before it.
  const double periods = last_index_ < 0 ? 1.0 : (time_s - last_time_s_) * frame_rate_hz_;
  const long advance = std::isfinite(periods) ? std::max(1L, std::lround(periods)) : 1L;
  last_time_s_ = time_s;
  last_index_ += advance;
  return {last_index_, advance - 1};
}

}  // namespace pellucida
