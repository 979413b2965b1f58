#pragma once
#include <cstddef>

namespace pellucida {

/// A puncture is noticed within this time, s; what has come back by more than this, um, until then is the membrane on
/// its way.
inline constexpr double kGivingWayNoticed_s = 0.2, kGivingWayBack_um = 1.0;

/// How many of the first `end` points of a contact, in the order of time, come before the membrane gave way. While a
/// puncture is in doubt the force stays and the membrane goes back already: such points are on no curve of force over
/// depth. `time_s` and `depth_um` take a point's number; `noticed_s`: when the puncture was seen.
template <class Time, class Depth>
std::size_t count_before_giving_way(std::size_t end, double noticed_s, Time time_s, Depth depth_um) {
  std::size_t count = end;
  for (std::size_t i = end; i-- > 0 && time_s(i) >= noticed_s - kGivingWayNoticed_s;) {
    if (depth_um(i) > depth_um(count - 1) + kGivingWayBack_um) count = i + 1;
  }
  return count;
}

}  // namespace pellucida
