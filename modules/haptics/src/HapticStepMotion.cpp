// How the hand leads the pipette: the part of the step from the motion map to the two proxies.
#include <algorithm>

#include "pellucida/haptics/HapticStep.h"

namespace pellucida {
namespace {

// So far ahead of the held pipette the hand may be before it's tied anew: more than it trembles.
constexpr double kHeldSlack_um = 2.0;

}  // namespace

void HapticStep::tie(const HapticInput& input) noexcept {
  if (!placed_) {
    predictor_.shift(pipette_.tip_um.eigen() - guards_.tip_um());
    guards_.place(pipette_.tip_um.eigen());
    history_.clear();
    history_.add(input.now_s, guards_.tip_um());
  }
  take_over(input.hand);
  tied_ = placed_ = worked_ = true;
  was_clutched_ = false;
}

void HapticStep::take_over(const HandSample& hand) noexcept {
  map_.engage(hand, guards_.tip_um());
  felt_.place(guards_.tip_um());
  leading_force_N_.setZero();
}

void HapticStep::move(const HapticInput& input, Tick& tick, HandState& state) noexcept {
  tick.wanted_um = felt_.tip_um();
  tick.guard = guards_.hold();
  tick.felt = felt_.hold();
  // What the link and the fixtures gave last fades out with the rest when the hand no longer leads.
  tick.force_W_N = leading_force_N_;
  if (state != HandState::kWorking) return;

  const TipTarget target = map_.update(input.hand, input.dt_s);
  if (target.clutched) {
    state = HandState::kClutched;
    was_clutched_ = true;
    return;
  }
  if (was_clutched_) {
    // The target may have been ahead of the held proxy: the hand takes it where it is.
    take_over(input.hand);
    tick.felt = felt_.hold();
    tick.force_W_N.setZero();
    was_clutched_ = false;
    return;
  }
  GuardInput guard;
  guard.push = push_;
  guard.in_contact = contact_.state == ContactState::kContact && push_.squaredNorm() > 0.0;
  guard.contact_force_uN = contact_.along_uN;
  guard.depth_um = contact_.depth_um;
  guard.pipette = pipette_;
  guard.dt_s = std::clamp(input.dt_s, 0.0, settings_.limits.late_tick_s);
  if ((input.hand.buttons & kRetract) != 0) {
    if (push_.squaredNorm() > 0.0) tick.guard = guards_.retract(guard);
    take_over(input.hand);
    tick.felt = tick.guard;
    tick.force_W_N.setZero();
    tick.wanted_um = guards_.tip_um();
    tick.acting |= tick.guard.limits;
    return;
  }
  if (!is_finite(target.tip_um.eigen()) || !is_finite(target.ahead_um.eigen())) return;
  const bool no_deeper = blind() || just_punctured(input.now_s);
  if (no_deeper && pushes(target)) {
    // The hand goes on without the pipette, and takes it again when it comes back by a little more than it trembles.
    if (blind()) act(tick, LimitKind::kBlind, contact_.age_s, settings_.limits.blind_age_s);
    const Eigen::Vector3d way_um = target.tip_um.eigen() + target.ahead_um.eigen() - guards_.tip_um();
    if (way_um.dot(push_) > kHeldSlack_um) {
      map_.engage(input.hand, Eigen::Vector3d(guards_.tip_um() + kHeldSlack_um * push_));
    }
    stand(tick);
    held_ = true;
    return;
  }
  if (held_) {
    // Back, or free again: the hand takes the pipette where it is, without what was left of that little more.
    take_over(input.hand);
    stand(tick);
    held_ = false;
    return;
  }
  lead(target, tick, guard);
}

void HapticStep::stand(Tick& tick) noexcept {
  felt_.place(guards_.tip_um());
  tick.felt = felt_.hold();
  tick.fixtures = apply(fixtures_, guards_.tip_um(), Eigen::Vector3d::Zero(), tick.scale_um_per_m,
                        smooth_step(fixture_part_.value()));
  tick.force_W_N = leading_force_N_ = tick.fixtures.force_N;
}

bool HapticStep::blind() const noexcept {
  const bool unknown = contact_.state == ContactState::kStale || contact_.state == ContactState::kInvalid;
  return unknown && contact_.age_s > settings_.limits.blind_age_s;
}

bool HapticStep::just_punctured(double now_s) const noexcept {
  return now_s - punctured_s_ < settings_.limits.puncture_hold_s;
}

bool HapticStep::pushes(const TipTarget& target) const noexcept {
  if (push_.squaredNorm() <= 0.0) return false;
  const Eigen::Vector3d way_um = target.tip_um.eigen() + target.ahead_um.eigen() - felt_.tip_um();
  return way_um.dot(push_) > 0.0;
}

void HapticStep::lead(const TipTarget& target, Tick& tick, GuardInput& guard) noexcept {
  const double fixture_part = smooth_step(fixture_part_.value());
  const Eigen::Vector3d target_um = target.tip_um.eigen(), ahead_um = target.ahead_um.eigen();
  const bool filtered = ahead_um.squaredNorm() > 0.0;
  // The hand's own speed where the map smooths it; else the map's estimate, which may not be the hand's at all.
  const Eigen::Vector3d hand_um_per_s = tick.scale_um_per_m * world_from_hand(tick.hand_velocity_m_per_s).eigen();
  const Eigen::Vector3d wanted_um_per_s = filtered ? hand_um_per_s : target.velocity_um_per_s.eigen();

  tick.wanted_um = target_um + ahead_um;
  tick.fixtures = apply(fixtures_, tick.wanted_um, wanted_um_per_s, tick.scale_um_per_m, fixture_part);
  // The manipulator's lag counts for both, measured on the proxy it was commanded.
  const Eigen::Vector3d apart_um = felt_.tip_um() - guards_.tip_um();
  GuardInput felt = guard;
  felt.wanted_um = tick.fixtures.allowed_um;
  felt.pipette.tip_um = Eigen::Vector3d(guard.pipette.tip_um.eigen() + apart_um);
  guard.wanted_um =
      filtered
          ? apply(fixtures_, target_um, target.velocity_um_per_s.eigen(), tick.scale_um_per_m, fixture_part).allowed_um
          : tick.fixtures.allowed_um;
  tick.guard = guards_.follow(guard);
  tick.felt = felt_.follow(felt);
  tick.acting |= tick.guard.limits | tick.felt.limits;
  // While nothing holds a proxy its velocity is the estimate, which is smoother than the differences.
  if (tick.guard.mode == GuardMode::kFollow) tick.guard.velocity_um_per_s = target.velocity_um_per_s.eigen();
  if (tick.felt.mode == GuardMode::kFollow) tick.felt.velocity_um_per_s = wanted_um_per_s;

  leading_force_N_ =
      tick.fixtures.force_N + coupling_.force_N(tick.felt.tip_um, felt.wanted_um,
                                                tick.felt.velocity_um_per_s - wanted_um_per_s, tick.scale_um_per_m);
  tick.force_W_N = leading_force_N_;
}

}  // namespace pellucida
