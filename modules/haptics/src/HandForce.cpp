#include "pellucida/haptics/HandForce.h"

#include <limits>

namespace pellucida {
namespace {

constexpr double kNoForce_N = 1e-9;

}  // namespace

HandForce::HandForce(const DeviceSpecification& device, double period_s) noexcept
    : max_force_N_(device.max_force_N), passivity_(device, period_s) {}

void HandForce::observe(const HandReadout& hand, bool follows, double dt_s) noexcept {
  if (!hand.good) return;
  if (follows && !hand.anew) {
    passivity_.observe(hand.position_m, written_N_, dt_s);
  } else {
    passivity_.rebase(hand.position_m);
  }
}

Eigen::Vector3d HandForce::written_N(const Eigen::Vector3d& wanted_W_N, const HandReadout& hand,
                                     const HapticSettings& settings, double dt_s, ActingLimits& acting) noexcept {
  if (max_force_N_ <= 0.0) return Eigen::Vector3d::Zero();
  Eigen::Vector3d wanted_N = work_.value() * hand_from_world(wanted_W_N).eigen();
  if (hand.good) {
    const Eigen::Vector3d damping_N = passivity_.damping_force_N(hand.velocity_m_per_s, dt_s);
    if (damping_N.norm() > kNoForce_N) acting.add(LimitKind::kPassivity, passivity_.margin_J());
    wanted_N += work_.value() * damping_N;
  }
  if (!is_finite(wanted_N)) {
    acting.add(LimitKind::kForceNotFinite);
    wanted_N.setZero();
  }
  filtered_N_ = low_pass(filtered_N_, wanted_N, settings.low_pass_Hz, settings.period_s);
  const double max_change_N = settings.full_scale_time_s > 0.0
                                  ? max_force_N_ * settings.period_s / settings.full_scale_time_s
                                  : std::numeric_limits<double>::infinity();
  const double change_N = (filtered_N_ - written_N_).norm();
  if (change_N > max_change_N) acting.add(LimitKind::kHandSlope, change_N, max_change_N);
  const Eigen::Vector3d sloped_N = limit_change(written_N_, filtered_N_, max_change_N);
  if (sloped_N.norm() > max_force_N_) acting.add(LimitKind::kHandForce, sloped_N.norm(), max_force_N_);
  written_N_ = saturate(sloped_N, max_force_N_);
  if (!is_finite(written_N_)) {
    written_N_.setZero();
    filtered_N_.setZero();
  }
  return written_N_;
}

}  // namespace pellucida
