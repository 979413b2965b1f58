#include "pellucida/haptics/PipetteLead.h"

#include <cmath>

namespace pellucida {
namespace {

// Changed fixtures go in this time and the new ones come in it.
constexpr double kFixtureFade_s = 0.1;

}  // namespace

PipetteLead::PipetteLead(MotionMap& map, const HapticSettings& settings, const DeviceSpecification& device) noexcept
    : map_(map),
      wanted_fixtures_(settings.fixtures),
      fixtures_(settings.fixtures),
      pipette_(settings.limits),
      hand_(settings.limits),
      link_(settings.coupling, device) {}

void PipetteLead::set(const HapticSettings& settings) noexcept {
  wanted_fixtures_ = settings.fixtures;
  pipette_.set(settings.limits);
  hand_.set(settings.limits);
  link_.set(settings.coupling);
}

void PipetteLead::begin_tick(double dt_s) noexcept {
  const double scale = map_.scale_um_per_m();
  scale_um_per_m_ = std::isfinite(scale) && scale > 0.0 ? scale : 1.0;
  const bool same = fixtures_ == wanted_fixtures_;
  fixture_part_.step(same ? 1.0 : 0.0, kFixtureFade_s, dt_s);
  if (!same && fixture_part_.value() <= 0.0) fixtures_ = wanted_fixtures_;
}

void PipetteLead::engage(const HandSample& hand) noexcept {
  map_.engage(hand, pipette_um());
  hand_.place(pipette_um());
  force_N_.setZero();
}

void PipetteLead::engage_ahead(const HandSample& hand, const Eigen::Vector3d& ahead_um) noexcept {
  map_.engage(hand, Eigen::Vector3d(pipette_um() + ahead_um));
}

LeadOutput PipetteLead::rest() const noexcept {
  LeadOutput output;
  output.wanted_um = hand_um();
  output.pipette = pipette_.hold();
  output.hand = hand_.hold();
  output.force_N = force_N_;
  return output;
}

LeadOutput PipetteLead::take(const HandSample& hand) noexcept {
  LeadOutput output = rest();
  engage(hand);
  output.hand = hand_.hold();
  output.force_N.setZero();
  return output;
}

LeadOutput PipetteLead::hold() noexcept {
  LeadOutput output = rest();
  hand_.place(pipette_um());
  output.hand = hand_.hold();
  output.fixtures =
      apply(fixtures_, pipette_um(), Eigen::Vector3d::Zero(), scale_um_per_m_, smooth_step(fixture_part_.value()));
  output.force_N = force_N_ = output.fixtures.force_N;
  return output;
}

LeadOutput PipetteLead::retract(const HandSample& hand, const GuardInput& guard) noexcept {
  LeadOutput output;
  // Without a known push there is no way out.
  output.pipette = guard.push.squaredNorm() > 0.0 ? pipette_.retract(guard) : pipette_.hold();
  engage(hand);
  output.hand = output.pipette;
  output.wanted_um = pipette_um();
  return output;
}

LeadOutput PipetteLead::follow(const TipTarget& target, const Eigen::Vector3d& hand_velocity_m_per_s,
                               GuardInput guard) noexcept {
  LeadOutput output;
  const double fixture_part = smooth_step(fixture_part_.value());
  const Eigen::Vector3d target_um = target.tip_um.eigen(), ahead_um = target.ahead_um.eigen();
  const bool smoothed = ahead_um.squaredNorm() > 0.0;
  // The hand's own speed where the map smooths it; else the map's estimate, which may not be the hand's at all.
  const Eigen::Vector3d hand_um_per_s = scale_um_per_m_ * world_from_hand(hand_velocity_m_per_s).eigen();
  const Eigen::Vector3d wanted_um_per_s = smoothed ? hand_um_per_s : target.velocity_um_per_s.eigen();

  output.wanted_um = target_um + ahead_um;
  output.fixtures = apply(fixtures_, output.wanted_um, wanted_um_per_s, scale_um_per_m_, fixture_part);
  // The manipulator's lag counts for both, measured on the proxy it is commanded to.
  const Eigen::Vector3d apart_um = hand_um() - pipette_um();
  GuardInput hand_guard = guard;
  hand_guard.wanted_um = output.fixtures.allowed_um;
  hand_guard.pipette.tip_um = Eigen::Vector3d(guard.pipette.tip_um.eigen() + apart_um);
  guard.wanted_um =
      smoothed ? apply(fixtures_, target_um, target.velocity_um_per_s.eigen(), scale_um_per_m_, fixture_part).allowed_um
               : output.fixtures.allowed_um;
  output.pipette = pipette_.follow(guard);
  output.hand = hand_.follow(hand_guard);
  // While nothing holds a proxy its velocity is the estimate, which is smoother than the differences.
  if (output.pipette.mode == GuardMode::kFollow) output.pipette.velocity_um_per_s = target.velocity_um_per_s.eigen();
  if (output.hand.mode == GuardMode::kFollow) output.hand.velocity_um_per_s = wanted_um_per_s;

  force_N_ = output.fixtures.force_N + link_.force_N(output.hand.tip_um, hand_guard.wanted_um,
                                                     output.hand.velocity_um_per_s - wanted_um_per_s, scale_um_per_m_);
  output.force_N = force_N_;
  return output;
}

}  // namespace pellucida
