#include "TrialMeter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pellucida {

TrialMeter::TrialMeter(const TrialOptions& options, const InjectionPlan& plan) noexcept
    : options_(options), plan_(plan) {
  seen_.modality = options.modality;
  seen_.seed = options.seed;
}

// The mean over the ring's time, once it is full.
void TrialMeter::follow_speed(const SpecimenMoment& moment, double along_um) noexcept {
  double& oldest_um = commanded_um_[static_cast<std::size_t>(tick_) % kSpeedTicks];
  const double speed_um_per_s = (along_um - oldest_um) / (1e-3 * static_cast<double>(kSpeedTicks));
  const bool full = tick_ >= static_cast<long>(kSpeedTicks);
  oldest_um = along_um;
  if (!full || !inserting_ || deposit_begun_) return;
  if (seen_.punctured) {
    seen_.peak_after_puncture_um_per_s = std::max(seen_.peak_after_puncture_um_per_s, speed_um_per_s);
  } else if (moment.state == CellState::kContact) {
    seen_.peak_approach_um_per_s = std::max(seen_.peak_approach_um_per_s, speed_um_per_s);
  }
}

void TrialMeter::look(const SpecimenMoment& moment, const HapticRecord& record, OperatorPhase phase) noexcept {
  const Eigen::Vector3d axis = plan_.axis.eigen(), from_entry = moment.tip_um.eigen() - plan_.entry_um.eigen();
  const double along_um = from_entry.dot(axis);
  const double lateral_um = (from_entry - along_um * axis).norm();
  time_s_ = moment.time_s;
  inserting_ = phase == OperatorPhase::kInsert;
  deposit_begun_ = deposit_begun_ || phase == OperatorPhase::kDeposit;
  if (!touched_ && moment.state != CellState::kFree) {
    touched_ = true;
    touch_s_ = moment.time_s;
  }

  if (inserting_) {
    ++insertion_ticks_;
    lateral_sum_um2_ += lateral_um * lateral_um;
    seen_.lateral_max_um = std::max(seen_.lateral_max_um, lateral_um);
  }
  if (phase == OperatorPhase::kInsert || phase == OperatorPhase::kDeposit)
    seen_.overshoot_um = std::max(seen_.overshoot_um, along_um - plan_.depth_um);
  seen_.peak_force_uN = std::max({seen_.peak_force_uN, moment.reply.force_uN.eigen().norm(), moment.puncture_force_uN});
  seen_.peak_hand_force_N = std::max(seen_.peak_hand_force_N, record.hand_force_N.eigen().norm());
  seen_.limits |= record.limits;
  follow_speed(moment, (record.tip_um.eigen() - plan_.entry_um.eigen()).dot(axis));
  if (!seen_.punctured && moment.puncture_count > 0) {
    seen_.punctured = true;
    puncture_s_ = moment.time_s;
    puncture_along_um_ = along_um;
  }
  if (phase == OperatorPhase::kDone && moment.state == CellState::kFree) seen_.removed = true;
  last_ = moment;
  ++tick_;
}

TrialOutcome TrialMeter::outcome() const noexcept {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  TrialOutcome outcome = seen_;
  outcome.duration_s = time_s_;
  outcome.insertion_s = insertion_ticks_ > 0 ? 1e-3 * static_cast<double>(insertion_ticks_) : kNone;
  outcome.lateral_rms_um =
      insertion_ticks_ > 0 ? std::sqrt(lateral_sum_um2_ / static_cast<double>(insertion_ticks_)) : kNone;
  if (insertion_ticks_ == 0) outcome.lateral_max_um = outcome.overshoot_um = kNone;
  // From the touch to the depth where the membrane gave way.
  const double push_s = last_.puncture_count > 0 ? puncture_s_ - touch_s_ : 0.0;
  outcome.mean_approach_um_per_s = push_s > 0.0 ? puncture_along_um_ / push_s : kNone;
  if (!touched_) outcome.peak_approach_um_per_s = kNone;
  if (!seen_.punctured) outcome.peak_after_puncture_um_per_s = kNone;

  // How far from the target the droplets lie, by volume.
  double volume_pL = 0.0, sum = 0.0;
  for (int k = 0; k < last_.droplet_count; ++k) {
    const Droplet& droplet = last_.droplets[static_cast<std::size_t>(k)];
    volume_pL += droplet.volume_pL;
    sum += droplet.volume_pL * (droplet.center_um.eigen() - plan_.target_um.eigen()).norm();
  }
  outcome.deposited_pL = last_.deposited_pL;
  outcome.lost_pL = last_.lost_pL;
  outcome.deposit_error_um = volume_pL > 0.0 ? sum / volume_pL : kNone;
  const double expelled_pL = last_.deposited_pL + last_.lost_pL;
  outcome.deposited = volume_pL > 0.0 && last_.deposited_pL >= options_.least_deposit_ratio * expelled_pL &&
                      outcome.deposit_error_um <= options_.tolerance_um;
  outcome.success =
      outcome.punctured && outcome.deposited && outcome.removed && outcome.overshoot_um <= options_.max_overshoot_um;
  return outcome;
}

}  // namespace pellucida
