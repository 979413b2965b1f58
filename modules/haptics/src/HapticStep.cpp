#include "pellucida/haptics/HapticStep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pellucida {
namespace {

// Changed fixtures go in this time and the new ones come in it.
constexpr double kFixtureFade_s = 0.1;
constexpr double kNoForce_N = 1e-9;

}  // namespace

HapticStep::HapticStep(const DeviceSpecification& device, MotionMap& map, const HapticSettings& settings) noexcept
    : device_(device),
      map_(map),
      settings_(settings),
      fixtures_(settings.fixtures),
      hand_velocity_(device.resolution_m),
      guards_(settings.limits),
      felt_(settings.limits),
      predictor_(settings.predictor),
      coupling_(settings.coupling, device),
      passivity_(device, settings.period_s) {}

void HapticStep::set(const HapticSettings& settings) noexcept {
  settings_ = settings;
  guards_.set(settings.limits);
  felt_.set(settings.limits);
  predictor_.set(settings.predictor);
  coupling_.set(settings.coupling);
}

void HapticStep::see(const ContactModel& model) noexcept {
  predictor_.see(model, history_);
  const double length = model.push.eigen().norm();
  if (model.valid && length > 0.5 && length < 2.0) push_ = model.push.eigen() / length;
}

void HapticStep::see(const PipetteState& pipette) noexcept {
  const auto report = pipette_guard_.check(pipette, settings_.limits.max_pipette_speed_um_per_s);
  pipette_known_ = report != PipetteGuard::Report::kUnknown;
  pipette_jumped_ = pipette_jumped_ || report == PipetteGuard::Report::kJump;
  if (pipette_known_) pipette_ = pipette;
}

void HapticStep::act(Tick& tick, LimitKind kind, double value, double limit) noexcept {
  tick.acting |= limit_bit(kind);
  limits_.note(kind, value, limit);
}

void HapticStep::latch_stop(const HapticInput& input, Tick& tick) noexcept {
  const bool pressed = input.hand_read && (input.hand.buttons & kEmergency) != 0;
  if (input.stop_requested || pressed) {
    stopped_ = true;
  } else if (stopped_ && input.release_requested) {
    stopped_ = false;
  }
  if (!stopped_) return;
  act(tick, LimitKind::kEmergencyStop);
  // The pipette may have run on by its braking way: the proxy starts from where it is then.
  tied_ = placed_ = false;
}

void HapticStep::read_hand(const HapticInput& input, Tick& tick) noexcept {
  if (!input.hand_read) {
    act(tick, LimitKind::kHandLost);
    hand_guard_.clear();
    hand_velocity_.clear();
    return;
  }
  const HandReading reading = hand_guard_.check(input.hand, input.dt_s, settings_.limits.max_hand_speed_m_per_s);
  if (reading == HandReading::kNotFinite) {
    act(tick, LimitKind::kHandInvalid);
    return;
  }
  tick.hand_good = true;
  tick.hand_m = input.hand.position_m.eigen();
  if (reading == HandReading::kJump) {
    act(tick, LimitKind::kHandJump);
    hand_velocity_.clear();
    tick.tie_anew = true;
  }
  if (input.dt_s > settings_.limits.late_tick_s) {
    act(tick, LimitKind::kLateTick, input.dt_s, settings_.limits.late_tick_s);
    hand_velocity_.clear();
    tick.tie_anew = true;
  }
  const Eigen::Vector3d estimated = hand_velocity_.update(input.now_s, tick.hand_m);
  tick.hand_velocity_m_per_s = input.hand.velocity_known ? input.hand.velocity_m_per_s.eigen() : estimated;
  if (tick.tie_anew || !tied_) {
    passivity_.rebase(tick.hand_m);
  } else {
    passivity_.observe(tick.hand_m, written_N_, input.dt_s);
  }
}

HandState HapticStep::decide(const HapticInput& input, Tick& tick) noexcept {
  const double age_s = input.now_s - pipette_.time_s;
  const bool pipette_good = pipette_known_ && age_s <= settings_.limits.pipette_age_limit_s;
  if (!pipette_good) {
    if (worked_) act(tick, LimitKind::kPipetteLost, pipette_known_ ? age_s : 0.0, settings_.limits.pipette_age_limit_s);
    placed_ = false;
  }
  if (pipette_jumped_) {
    act(tick, LimitKind::kPipetteJump);
    pipette_jumped_ = placed_ = false;
  }
  if (stopped_) return HandState::kStopped;
  if (!tick.hand_good || !pipette_good || input.let_go) {
    tied_ = false;
    return worked_ ? HandState::kHeld : HandState::kWaiting;
  }
  if (!tied_ || !placed_ || tick.tie_anew) tie(input);
  return HandState::kWorking;
}

void HapticStep::feel(const HapticInput& input, Tick& tick, HandState state) noexcept {
  history_.add(input.now_s, tick.guard.tip_um);
  const double per_scale = settings_.force_scale_N_per_uN * tick.scale_um_per_m;
  if (per_scale > 0.0) predictor_.limit_stiffness(device_.max_stiffness_N_per_m / per_scale);
  contact_ = predictor_.update(input.now_s, input.dt_s, tick.felt.tip_um, tick.felt.velocity_um_per_s);
  if (contact_.punctured_now) punctured_s_ = input.now_s;
  switch (contact_.state) {
    case ContactState::kStale:
      act(tick, LimitKind::kContactStale, contact_.age_s, settings_.predictor.age_limit_s);
      break;
    case ContactState::kInvalid:
      act(tick, LimitKind::kContactInvalid);
      break;
    case ContactState::kPunctured:
      act(tick, LimitKind::kPuncture);
      break;
    default:
      break;
  }
  if (device_.max_force_N > 0.0) {
    force_scale_N_per_uN_ = coupling_.force_scale_N_per_uN(settings_.force_scale_N_per_uN, contact_.stiffness_uN_per_um,
                                                           tick.scale_um_per_m, input.dt_s);
    if (coupling_.scaled_down()) {
      act(tick, LimitKind::kHandStiffness, per_scale * contact_.stiffness_uN_per_um, device_.max_stiffness_N_per_m);
    }
  }
  tick.force_W_N += force_scale_N_per_uN_ * contact_.force_uN;
  if (state == HandState::kWorking) tick.force_W_N += world_from_hand(map_.hand_force_N(input.hand)).eigen();

  const bool works = state == HandState::kWorking;
  const double time_s = works                           ? settings_.fade_in_time_s
                        : state == HandState::kClutched ? settings_.clutch_time_s
                                                        : settings_.release_time_s;
  work_.step(works ? 1.0 : 0.0, time_s, input.dt_s);
}

void HapticStep::fade_fixtures(double dt_s) noexcept {
  const bool same = fixtures_ == settings_.fixtures;
  fixture_part_.step(same ? 1.0 : 0.0, kFixtureFade_s, dt_s);
  if (!same && fixture_part_.value() <= 0.0) fixtures_ = settings_.fixtures;
}

Eigen::Vector3d HapticStep::guarded_force_N(const HapticInput& input, Tick& tick) noexcept {
  if (device_.max_force_N <= 0.0) return Eigen::Vector3d::Zero();
  Eigen::Vector3d wanted_N = work_.value() * hand_from_world(tick.force_W_N).eigen();
  if (tick.hand_good) {
    const Eigen::Vector3d damping_N = passivity_.damping_force_N(tick.hand_velocity_m_per_s, input.dt_s);
    if (damping_N.norm() > kNoForce_N) act(tick, LimitKind::kPassivity, passivity_.margin_J());
    wanted_N += work_.value() * damping_N;
  }
  if (!is_finite(wanted_N)) {
    act(tick, LimitKind::kForceNotFinite);
    wanted_N.setZero();
  }
  filtered_N_ = low_pass(filtered_N_, wanted_N, settings_.low_pass_Hz, settings_.period_s);
  const double max_change_N = settings_.full_scale_time_s > 0.0
                                  ? device_.max_force_N * settings_.period_s / settings_.full_scale_time_s
                                  : std::numeric_limits<double>::infinity();
  const double change_N = (filtered_N_ - written_N_).norm();
  if (change_N > max_change_N) act(tick, LimitKind::kHandSlope, change_N, max_change_N);
  const Eigen::Vector3d sloped_N = limit_change(written_N_, filtered_N_, max_change_N);
  if (sloped_N.norm() > device_.max_force_N) {
    act(tick, LimitKind::kHandForce, sloped_N.norm(), device_.max_force_N);
  }
  written_N_ = saturate(sloped_N, device_.max_force_N);
  if (!is_finite(written_N_)) {
    written_N_.setZero();
    filtered_N_.setZero();
  }
  return written_N_;
}

void HapticStep::note_limits(const Tick& tick) noexcept {
  const CellLimits& limits = settings_.limits;
  const auto note = [&](LimitKind kind, double value, double limit) {
    if ((tick.acting & limit_bit(kind)) != 0) limits_.note(kind, value, limit);
  };
  note(LimitKind::kDepth, contact_.depth_um, limits.max_depth_um);
  note(LimitKind::kForce, contact_.along_uN, limits.max_force_uN);
  note(LimitKind::kSpeed, tick.guard.velocity_um_per_s.norm(), limits.max_speed_um_per_s);
  note(LimitKind::kFollowing, (tick.guard.tip_um - pipette_.tip_um.eigen()).norm(), limits.max_lag_um);
}

HapticOutput HapticStep::compute(const HapticInput& input) noexcept {
  HapticOutput output;
  Tick tick;
  const double scale = map_.scale_um_per_m();
  tick.scale_um_per_m = std::isfinite(scale) && scale > 0.0 ? scale : 1.0;

  latch_stop(input, tick);
  read_hand(input, tick);
  HandState state = decide(input, tick);
  fade_fixtures(input.dt_s);
  move(input, tick, state);
  feel(input, tick, state);
  output.force_N = guarded_force_N(input, tick);
  note_limits(tick);
  output.changes = limits_.update(input.now_s, tick.acting);
  fill(input, tick, state, output);
  return output;
}

void HapticStep::fill(const HapticInput& input, const Tick& tick, HandState state, HapticOutput& output) noexcept {
  const bool leads = state == HandState::kWorking || state == HandState::kClutched;
  PipetteCommand& command = output.command;
  command.time_s = input.now_s;
  command.tip_um = tick.guard.tip_um;
  command.velocity_um_per_s = tick.guard.velocity_um_per_s;
  command.max_speed_um_per_s = leads ? settings_.limits.max_speed_um_per_s : 0.0;
  command.inject = leads && (input.hand.buttons & kInject) != 0;
  command.stop = stopped_;

  HapticRecord& record = output.record;
  record.time_s = input.now_s;
  record.hand_m = tick.hand_m;
  record.hand_velocity_m_per_s = tick.hand_velocity_m_per_s;
  record.wanted_um = tick.wanted_um;
  record.tip_um = tick.guard.tip_um;
  record.pipette_um = pipette_.tip_um;
  record.hand_force_N = output.force_N;
  record.contact_force_uN = contact_.force_uN;
  record.guide_force_N = hand_from_world(Eigen::Vector3d(work_.value() * tick.fixtures.force_N));
  record.depth_um = contact_.depth_um;
  record.contact_age_s = contact_.age_s;
  record.contact_frame_index = contact_.frame_index;
  record.energy_margin_J = passivity_.margin_J();
  record.hand_stiffness_N_per_m = force_scale_N_per_uN_ * contact_.stiffness_uN_per_um * tick.scale_um_per_m;
  record.scale_um_per_m = tick.scale_um_per_m;
  record.limits = tick.acting;
  record.fixtures = tick.fixtures.acting;
  record.buttons = input.hand_read ? input.hand.buttons : 0;
  record.contact_state = contact_.state;
  record.hand_state = state;
}

}  // namespace pellucida
