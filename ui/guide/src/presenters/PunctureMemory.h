#pragma once
#include <optional>
#include <span>
#include <string>

#include "pellucida/core/Event.h"

namespace pellucida {

/// The last puncture, which stays on screen until the next cell: one that **New cell** brought, or one that was found
/// anew and touched.
class PunctureMemory {
 public:
  struct Puncture {
    double time_s = 0.0;
    double force_uN = 0.0;
    double depth_um = 0.0;
    double work_pJ = 0.0;
  };

  /// The run's next events, in order.
  void take(std::span<const Event> events);
  const std::optional<Puncture>& last() const noexcept { return last_; }
  /// "7.27 µN · 43.6 µm · 62 pJ"; empty without one.
  std::string text() const;

 private:
  std::optional<Puncture> last_;
  bool found_anew_ = false;
};

}  // namespace pellucida
