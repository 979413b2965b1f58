#include "pellucida/visualization/Scaling.h"

#include "pellucida/core/RoundNumbers.h"

namespace pellucida {

double NiceRange::update(double maximum) noexcept {
  const double wanted = nice_ceiling(maximum, floor_);
  if (wanted > upper_) {
    upper_ = wanted;
    small_count_ = 0;
  } else if (maximum < 0.4 * upper_ && wanted < upper_) {
    if (++small_count_ > kPatience) {
      upper_ = wanted;
      small_count_ = 0;
    }
  } else {
    small_count_ = 0;
  }
  return upper_;
}

}  // namespace pellucida
