#pragma once
#include <array>
#include <cstddef>

#include "pellucida/evaluation/Trial.h"
#include "pellucida/haptics/HapticRecord.h"
#include "pellucida/simulation/SimulatedOperator.h"
#include "pellucida/simulation/SpecimenContact.h"

namespace pellucida {

/// Watches a trial tick by tick and says in the end what came of it.
class TrialMeter {
 public:
  TrialMeter(const TrialOptions& options, const InjectionPlan& plan) noexcept;

  /// A tick of 1 ms: the cell with the tip where it truly is, what the loop did, what the operator does.
  void look(const SpecimenMoment& moment, const HapticRecord& record, OperatorPhase phase) noexcept;
  TrialOutcome outcome() const noexcept;

 private:
  void follow_speed(const SpecimenMoment& moment, double along_um) noexcept;

  static constexpr std::size_t kSpeedTicks = 20;

  TrialOptions options_;
  InjectionPlan plan_;
  TrialOutcome seen_;
  std::array<double, kSpeedTicks> commanded_um_{};  ///< along the line, a ring
  long tick_ = 0, insertion_ticks_ = 0;
  double time_s_ = 0.0, touch_s_ = 0.0, puncture_s_ = 0.0, puncture_along_um_ = 0.0;
  double lateral_sum_um2_ = 0.0;
  bool touched_ = false, inserting_ = false, deposit_begun_ = false;
  SpecimenMoment last_;
};

}  // namespace pellucida
