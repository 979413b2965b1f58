#include "pellucida/teleoperation/TeleoperationMap.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using Control = TeleoperationSettings::Control;

void demand_positive(double value, const char* what) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw UsageError(std::string("teleoperation: ") + what + " must be above 0, not " + std::to_string(value));
}

void check_tremor(const TremorOptions& tremor) {
  demand_positive(tremor.rest_cutoff_Hz, "the tremor filter's cut-off in Hz");
  demand_positive(tremor.max_cutoff_Hz, "the tremor filter's highest cut-off in Hz");
  if (!(tremor.cutoff_rise_Hz_s_per_m >= 0.0)) {
    throw UsageError("teleoperation: the rise of the tremor filter's cut-off must be 0 or above");
  }
}

Eigen::Vector3d world(const Eigen::Vector3d& hand) noexcept {
  return world_from_hand(hand).eigen();
}

}  // namespace

void TeleoperationMap::check(const TeleoperationSettings& s) {
  demand_positive(s.scale_um_per_m, "the scale in um/m");
  demand_positive(s.rate_um_per_s_per_m, "the rate in um/s per m");
  for (const double value : {s.dead_zone_m, s.centring_N_per_m, s.max_centring_force_N}) {
    if (!(value >= 0.0) || !std::isfinite(value)) {
      throw UsageError("teleoperation: dead zone, centring stiffness and force must be 0 or above, not " +
                       std::to_string(value));
    }
  }
  if (!(s.box.lower_um.eigen().array() <= s.box.upper_um.eigen().array()).all()) {
    throw UsageError("teleoperation: the box's lower corner must not be above its upper corner, on any axis");
  }
}

TeleoperationMap::TeleoperationMap(const TeleoperationSettings& settings, const TremorOptions& tremor)
    : settings_(settings), asked_tremor_(tremor), filter_(tremor) {
  check(settings);
  check_tremor(tremor);
}

void TeleoperationMap::request(const TeleoperationSettings& settings) {
  request(settings, asked_tremor_);
}

void TeleoperationMap::request(const TeleoperationSettings& settings, const TremorOptions& tremor) {
  check(settings);
  check_tremor(tremor);
  asked_tremor_ = tremor;
  requested_.publish({settings, tremor});
}

void TeleoperationMap::engage(const HandSample& hand, const PlainVector3& tip_um) noexcept {
  if (!tip_um.eigen().allFinite()) return;
  tip_um_ = tip_um.eigen();
  anchor(hand.position_m.eigen());
  clutched_ = false;
  fresh_ = true;
}

void TeleoperationMap::anchor(const Eigen::Vector3d& hand_m) noexcept {
  filter_.reset(hand_m);
  anchor_um_ = tip_um_;
  const bool own_centre = settings_.control == Control::kRate && settings_.self_centring;
  if (own_centre) {
    centre_m_ = {};
  } else if (hand_m.allFinite()) {
    centre_m_ = hand_m;
  }
  seen_rest_ = !own_centre;
}

void TeleoperationMap::apply(const Request& request, const HandSample& hand) noexcept {
  const TeleoperationSettings& asked = request.settings;
  const bool other_control = asked.control != settings_.control || asked.self_centring != settings_.self_centring;
  const bool other_filter = request.tremor.enabled != filter_.options().enabled;
  settings_ = asked;
  filter_.set_options(request.tremor);
  if (other_control) {
    anchor(hand.position_m.eigen());
    return;
  }
  // A low-pass that comes or goes starts from where the hand is.
  if (other_filter) filter_.reset(hand.position_m.eigen());
  if (settings_.control == Control::kPosition) {
    // From where the filter is, not the hand: what it still lags is not lost.
    anchor_um_ = tip_um_;
    centre_m_ = filter_.position_m();
  }
}

TipTarget TeleoperationMap::update(const HandSample& hand, double dt_s) noexcept {
  if (requested_.refresh()) apply(requested_.value(), hand);
  TipTarget target{tip_um_, {}, (hand.buttons & kClutch) != 0};
  const Eigen::Vector3d hand_m = hand.position_m.eigen();
  const bool released = clutched_ && !target.clutched;
  clutched_ = target.clutched;
  if (released || fresh_) anchor(hand_m);
  const bool still = target.clutched || released || fresh_;
  fresh_ = fresh_ && !hand_m.allFinite();
  if (still || !hand_m.allFinite() || !(dt_s > 0.0) || !std::isfinite(dt_s)) return target;

  filter_.update(hand_m, dt_s);
  const Eigen::Vector3d before_um = tip_um_;
  Eigen::Vector3d velocity_um_per_s;
  Eigen::Vector3d wished_um;
  if (settings_.control == Control::kPosition) {
    const Eigen::Vector3d moved_m = filter_.position_m() - centre_m_.eigen();
    wished_um = anchor_um_ + settings_.scale_um_per_m * world(moved_m);
    velocity_um_per_s = settings_.scale_um_per_m * world(filter_.velocity_m_per_s());
  } else {
    if (hand_m.norm() <= settings_.dead_zone_m) seen_rest_ = true;
    const Eigen::Vector3d deflection_m =
        seen_rest_ ? shaped_deflection_m(filter_.position_m()) : Eigen::Vector3d(Eigen::Vector3d::Zero());
    velocity_um_per_s = settings_.rate_um_per_s_per_m * world(deflection_m);
    wished_um = before_um + velocity_um_per_s * dt_s;
  }
  tip_um_ = clamped(wished_um);
  for (int axis = 0; axis < 3; ++axis) {
    if (tip_um_[axis] != wished_um[axis]) velocity_um_per_s[axis] = 0.0;
  }
  target.tip_um = tip_um_;
  target.velocity_um_per_s = velocity_um_per_s;
  if (settings_.control == Control::kPosition) {
    // Where the tip would be without the tremor filter.
    const Eigen::Vector3d unfiltered_um = anchor_um_ + settings_.scale_um_per_m * world(hand_m - centre_m_.eigen());
    target.ahead_um = Eigen::Vector3d(clamped(unfiltered_um) - tip_um_);
  }
  return target;
}

Eigen::Vector3d TeleoperationMap::shaped_deflection_m(const Eigen::Vector3d& hand_m) const noexcept {
  const Eigen::Vector3d deflection_m = hand_m - centre_m_.eigen();
  const double size_m = deflection_m.norm();
  if (size_m <= settings_.dead_zone_m) return Eigen::Vector3d::Zero();
  return deflection_m * ((size_m - settings_.dead_zone_m) / size_m);
}

Eigen::Vector3d TeleoperationMap::clamped(const Eigen::Vector3d& wished_um) const noexcept {
  // A tip engaged outside the box may come back, not go further.
  const Eigen::Vector3d lower_um = settings_.box.lower_um.eigen().cwiseMin(tip_um_);
  const Eigen::Vector3d upper_um = settings_.box.upper_um.eigen().cwiseMax(tip_um_);
  return wished_um.cwiseMax(lower_um).cwiseMin(upper_um);
}

PlainVector3 TeleoperationMap::centring_force_N(const HandSample& hand) const noexcept {
  const Eigen::Vector3d hand_m = hand.position_m.eigen();
  const bool pulls = settings_.control == Control::kRate && !settings_.self_centring && !clutched_;
  if (!pulls || !hand_m.allFinite()) return {};
  Eigen::Vector3d force_N = -settings_.centring_N_per_m * shaped_deflection_m(hand_m);
  const double size_N = force_N.norm();
  if (size_N > settings_.max_centring_force_N) force_N *= settings_.max_centring_force_N / size_N;
  return force_N;
}

}  // namespace pellucida
