#pragma once
#include <string>

#include "pellucida/core_vtk/FrameSource.h"

namespace pellucida {

/// Counts frames whose data were damaged, in stretches.
class DamageCounter {
 public:
  /// What the next frame says of it. `reason` counts where it is damaged.
  FrameDamage add(bool damaged, const std::string& reason) {
    FrameDamage damage{.damaged = damaged, .count_before = count_, .reason = damaged ? reason : ""};
    count_ = damaged ? count_ + 1 : 0;
    return damage;
  }

 private:
  long count_ = 0;  // of the stretch at hand
};

}  // namespace pellucida
