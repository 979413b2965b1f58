#include "pellucida/simulation/CommandedNeedle.h"

#include <cmath>

namespace pellucida {

CommandedNeedle::CommandedNeedle(const Scenario& scenario) {
  const VirtualSpecimen specimen(scenario);
  contact_ = specimen.contact();
  force_ = specimen.force();
  puncture_force_uN_ = contact_.puncture_force_uN();
  start_um_ = force_.tip_at(specimen.offset_um(), -scenario.motion.gap_um);
  SpecimenContact first = contact_;
  waiting_ = first.advance(start_um_, 0.0);
}

const SpecimenMoment& CommandedNeedle::move(double time_s, const PlainVector3& tip_um,
                                            const PlainVector3& velocity_um_per_s, double expelled_pL) noexcept {
  if (renew_wanted_.exchange(false, std::memory_order_acquire)) contact_.reset();
  if (!std::isfinite(time_s) || !tip_um.eigen().allFinite()) return contact_.moment();
  const SpecimenMoment& moment = contact_.advance(tip_um, time_s, expelled_pL);
  newest_.publish({velocity_um_per_s, expelled_pL, moment});
  return moment;
}

NeedleCommand CommandedNeedle::at(double) {
  if (newest_.refresh()) moved_ = true;
  NeedleCommand command;
  command.moment = moved_ ? newest_.value().moment : waiting_;
  command.tip_um = command.moment->tip_um;
  command.velocity_um_per_s = moved_ ? newest_.value().velocity_um_per_s : PlainVector3{};
  command.expelled_pL = moved_ ? newest_.value().expelled_pL : 0.0;
  return command;
}

}  // namespace pellucida
