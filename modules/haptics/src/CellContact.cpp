#include "pellucida/haptics/CellContact.h"

#include <cmath>

namespace pellucida {

CellContact CellContact::for_next_hand(const PredictorSettings& settings) const noexcept {
  CellContact next = *this;
  next.predictor_.set(settings);
  next.predictor_.fade_in();
  return next;
}

void CellContact::see(const ContactModel& model) noexcept {
  predictor_.see(model, history_);
  const double length = model.push.eigen().norm();
  if (model.valid && length > 0.5 && length < 2.0) push_ = model.push.eigen() / length;
}

void CellContact::place(double now_s, const Eigen::Vector3d& tip_um) noexcept {
  predictor_.shift(tip_um - tip_um_);
  tip_um_ = tip_um;
  history_.clear();
  history_.add(now_s, tip_um);
}

const ContactForce& CellContact::update(double now_s, double dt_s, const Eigen::Vector3d& pipette_um,
                                        const GuardOutput& hand, double max_stiffness_uN_per_um) noexcept {
  history_.add(now_s, pipette_um);
  tip_um_ = pipette_um;
  if (std::isfinite(max_stiffness_uN_per_um)) predictor_.limit_stiffness(max_stiffness_uN_per_um);
  force_ = predictor_.update(now_s, dt_s, hand.tip_um, hand.velocity_um_per_s);
  if (force_.punctured_now) punctured_s_ = now_s;
  return force_;
}

bool CellContact::is_blind(const CellLimits& limits) const noexcept {
  const bool unknown = force_.state == ContactState::kStale || force_.state == ContactState::kInvalid;
  return unknown && force_.age_s > limits.blind_age_s;
}

}  // namespace pellucida
