#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "pellucida/planning/InjectionPlan.h"
#include "pellucida/simulation/SimulatedHand.h"

namespace pellucida {

/// The simulated operator that shows an injection, cell after cell.
class Demonstration {
 public:
  /// `rest_s`: between the end of one and the next cell.
  Demonstration(std::uint64_t seed, double rest_s) : seed_(seed), rest_s_(rest_s) {}

  /// The next operator's hand, for one plan; `modality`: what the operator sees and feels.
  std::unique_ptr<SimulatedHand> next_operator(const InjectionPlan& plan, double scale_um_per_m, Modality modality);

  /// True once the operator has been done for the rest; `now_s` is any monotonic clock.
  bool rested(OperatorPhase phase, double now_s) noexcept;
  /// It goes on, or another takes over.
  void begin_anew() noexcept { ended_s_.reset(); }

 private:
  std::uint64_t seed_;
  double rest_s_;
  std::optional<double> ended_s_;
};

/// Hand force for a force at the cell that a demonstration takes at most: 0.6 N at a puncture of 7.5 uN.
inline constexpr double kDemonstrationScale_N_per_uN = 0.08;

/// What the operator does, in a word or two.
const char* doing_words(OperatorPhase phase) noexcept;

}  // namespace pellucida
