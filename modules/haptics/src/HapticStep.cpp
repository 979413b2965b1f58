#include "pellucida/haptics/HapticStep.h"

#include <algorithm>
#include <limits>

namespace pellucida {
namespace {

// So far ahead of the held pipette the hand may be before it is engaged anew: more than it trembles.
constexpr double kHeldSlack_um = 2.0;

bool can_be_followed(const TipTarget& target) noexcept {
  return is_finite(target.tip_um.eigen()) && is_finite(target.ahead_um.eigen());
}

}  // namespace

HapticStep::HapticStep(const DeviceSpecification& device, MotionMap& map, const HapticSettings& settings,
                       const CellContact& known) noexcept
    : device_(device),
      settings_(settings),
      hand_reader_(device.resolution_m),
      contact_(known.for_next_hand(settings.predictor)),
      lead_(map, settings, device),
      force_(device, settings.period_s) {}

void HapticStep::set(const HapticSettings& settings) noexcept {
  settings_ = settings;
  lead_.set(settings);
  contact_.set(settings.predictor);
}

void HapticStep::see(const PipetteState& pipette) noexcept {
  pipette_.see(pipette, settings_.limits.max_pipette_speed_um_per_s);
}

void HapticStep::latch_stop(const HapticInput& input, ActingLimits& acting) noexcept {
  const bool pressed = input.hand_read && (input.hand.buttons & kEmergency) != 0;
  if (input.stop || pressed) {
    stopped_ = true;
  } else if (stopped_ && input.release_stop) {
    stopped_ = false;
  }
  if (!stopped_) return;
  acting.add(LimitKind::kEmergencyStop);
  // The pipette may have run on by its braking way: the proxy starts from where it is then.
  engagement_ = next(engagement_, EngagementEvent::kPipetteOut);
}

void HapticStep::check_readings(const HapticInput& input, const HandReadout& hand, ActingLimits& acting) noexcept {
  const bool pipette_there = pipette_.is_there(input.now_s, settings_.limits);
  if (!pipette_there) {
    if (engagement_ != Engagement::kWaiting) {
      acting.add(LimitKind::kPipetteLost, pipette_.age_s(input.now_s), settings_.limits.pipette_age_limit_s);
    }
    engagement_ = next(engagement_, EngagementEvent::kPipetteOut);
  }
  if (pipette_.take_jump()) {
    acting.add(LimitKind::kPipetteJump);
    engagement_ = next(engagement_, EngagementEvent::kPipetteOut);
  }
  if (!hand.good || hand.anew || input.release_hand) engagement_ = next(engagement_, EngagementEvent::kHandOut);
  if (stopped_ || !hand.good || !pipette_there || input.release_hand || is_engaged(engagement_)) return;

  if (engagement_ != Engagement::kReleased) {
    lead_.place(pipette_.state().tip_um.eigen());
    contact_.place(input.now_s, lead_.pipette_um());
  }
  lead_.engage(input.hand);
  engagement_ = next(engagement_, EngagementEvent::kReady);
}

EngagementEvent HapticStep::asked_by(const HapticInput& input, const TipTarget& target) const noexcept {
  if (target.clutched) return EngagementEvent::kClutch;
  // Out of the clutch it takes the pipette first, whatever else it asks.
  if (engagement_ == Engagement::kClutched) return EngagementEvent::kLead;
  if ((input.hand.buttons & kRetract) != 0) return EngagementEvent::kRetract;
  const bool no_deeper =
      contact_.is_blind(settings_.limits) || contact_.is_just_punctured(settings_.limits, input.now_s);
  const Eigen::Vector3d way_um = target.tip_um.eigen() + target.ahead_um.eigen() - lead_.hand_um();
  return no_deeper && way_um.dot(contact_.push()) > 0.0 ? EngagementEvent::kBar : EngagementEvent::kLead;
}

LeadOutput HapticStep::lead(const HapticInput& input, const HandReadout& hand, ActingLimits& acting) noexcept {
  if (!is_engaged(engagement_)) return lead_.rest();
  const TipTarget target = lead_.target(input.hand, input.dt_s);
  const Engagement before = engagement_;
  engagement_ = next(before, asked_by(input, target));
  if (engagement_ == Engagement::kClutched) return lead_.rest();
  if (engagement_ == Engagement::kHolding) return hold_ahead(input, target, acting);
  if (engagement_ == Engagement::kRetracting) {
    const LeadOutput output = lead_.retract(input.hand, guard_input(input.dt_s));
    acting.add(output.pipette.limits);
    return output;
  }
  // The target may have been ahead of the held proxy: the hand takes the pipette where it is.
  if (before == Engagement::kClutched) return lead_.take(input.hand);
  if (before == Engagement::kHolding) {
    lead_.engage(input.hand);
    return lead_.hold();
  }
  if (!can_be_followed(target)) return lead_.rest();
  const LeadOutput output = lead_.follow(target, hand.velocity_m_per_s, guard_input(input.dt_s));
  acting.add(output.pipette.limits | output.hand.limits);
  return output;
}

// The hand goes on without the pipette, and takes it again when it comes back by a little more than it trembles.
LeadOutput HapticStep::hold_ahead(const HapticInput& input, const TipTarget& target, ActingLimits& acting) noexcept {
  if (contact_.is_blind(settings_.limits)) {
    acting.add(LimitKind::kBlind, contact_.force().age_s, settings_.limits.blind_age_s);
  }
  const Eigen::Vector3d way_um = target.tip_um.eigen() + target.ahead_um.eigen() - lead_.pipette_um();
  if (way_um.dot(contact_.push()) > kHeldSlack_um) lead_.engage_ahead(input.hand, kHeldSlack_um * contact_.push());
  return lead_.hold();
}

GuardInput HapticStep::guard_input(double dt_s) const noexcept {
  GuardInput guard;
  guard.push = contact_.push();
  guard.in_contact = contact_.in_contact();
  guard.contact_force_uN = contact_.force().along_uN;
  guard.depth_um = contact_.force().depth_um;
  guard.pipette = pipette_.state();
  guard.dt_s = std::clamp(dt_s, 0.0, settings_.limits.late_tick_s);
  return guard;
}

void HapticStep::note_contact(const ContactForce& contact, ActingLimits& acting) const noexcept {
  switch (contact.state) {
    case ContactState::kStale:
      acting.add(LimitKind::kContactStale, contact.age_s, settings_.predictor.age_limit_s);
      break;
    case ContactState::kInvalid:
      acting.add(LimitKind::kContactInvalid);
      break;
    case ContactState::kPunctured:
      acting.add(LimitKind::kPuncture);
      break;
    default:
      break;
  }
}

void HapticStep::meet_cell(const HapticInput& input, Tick& tick, ActingLimits& acting) noexcept {
  const double scale_um_per_m = lead_.scale_um_per_m();
  const double per_scale = settings_.force_scale_N_per_uN * scale_um_per_m;
  const double stiffest =
      per_scale > 0.0 ? device_.max_stiffness_N_per_m / per_scale : std::numeric_limits<double>::infinity();
  const ContactForce& contact =
      contact_.update(input.now_s, input.dt_s, tick.lead.pipette.tip_um, tick.lead.hand, stiffest);
  note_contact(contact, acting);
  if (device_.max_force_N > 0.0) {
    force_scale_N_per_uN_ = lead_.link().force_scale_N_per_uN(settings_.force_scale_N_per_uN,
                                                              contact.stiffness_uN_per_um, scale_um_per_m, input.dt_s);
    if (lead_.link().scaled_down()) {
      acting.add(LimitKind::kHandStiffness, per_scale * contact.stiffness_uN_per_um, device_.max_stiffness_N_per_m);
    }
  }
  const bool works = tick.state == HandState::kWorking;
  tick.force_W_N = tick.lead.force_N + force_scale_N_per_uN_ * contact.force_uN;
  if (works) tick.force_W_N += lead_.map_force_N(input.hand);
  const double time_s = works                                ? settings_.fade_in_time_s
                        : tick.state == HandState::kClutched ? settings_.clutch_time_s
                                                             : settings_.release_time_s;
  force_.fade(works, time_s, input.dt_s);
}

void HapticStep::explain_limits(const Tick& tick, ActingLimits& acting) const noexcept {
  const CellLimits& limits = settings_.limits;
  const GuardOutput& pipette = tick.lead.pipette;
  acting.explain(LimitKind::kDepth, contact_.force().depth_um, limits.max_depth_um);
  acting.explain(LimitKind::kForce, contact_.force().along_uN, limits.max_force_uN);
  acting.explain(LimitKind::kSpeed, pipette.velocity_um_per_s.norm(), limits.max_speed_um_per_s);
  acting.explain(LimitKind::kFollowing, (pipette.tip_um - pipette_.state().tip_um.eigen()).norm(), limits.max_lag_um);
}

HandState HapticStep::hand_state() const noexcept {
  if (stopped_) return HandState::kStopped;
  if (engagement_ == Engagement::kWaiting) return HandState::kWaiting;
  if (engagement_ == Engagement::kClutched) return HandState::kClutched;
  return is_engaged(engagement_) ? HandState::kWorking : HandState::kHeld;
}

HapticOutput HapticStep::compute(const HapticInput& input) noexcept {
  HapticOutput output;
  Tick tick;
  ActingLimits acting(limits_);
  lead_.begin_tick(input.dt_s);
  latch_stop(input, acting);
  tick.hand =
      hand_reader_.read(input.hand_read ? &input.hand : nullptr, input.now_s, input.dt_s, settings_.limits, acting);
  force_.observe(tick.hand, is_engaged(engagement_), input.dt_s);
  check_readings(input, tick.hand, acting);
  tick.lead = lead(input, tick.hand, acting);
  tick.state = hand_state();
  meet_cell(input, tick, acting);
  output.force_N = force_.written_N(tick.force_W_N, tick.hand, settings_, input.dt_s, acting);
  explain_limits(tick, acting);
  output.changes = limits_.update(input.now_s, acting.mask());
  fill(input, tick, acting.mask(), output);
  return output;
}

void HapticStep::fill(const HapticInput& input, const Tick& tick, std::uint32_t acting,
                      HapticOutput& output) const noexcept {
  const bool leads = tick.state == HandState::kWorking || tick.state == HandState::kClutched;
  PipetteCommand& command = output.command;
  command.time_s = input.now_s;
  command.tip_um = tick.lead.pipette.tip_um;
  command.velocity_um_per_s = tick.lead.pipette.velocity_um_per_s;
  command.max_speed_um_per_s = leads ? settings_.limits.max_speed_um_per_s : 0.0;
  command.inject = leads && (input.hand.buttons & kInject) != 0;
  command.stop = stopped_;

  const ContactForce& contact = contact_.force();
  HapticRecord& record = output.record;
  record.time_s = input.now_s;
  record.hand_m = tick.hand.position_m;
  record.hand_velocity_m_per_s = tick.hand.velocity_m_per_s;
  record.wanted_um = tick.lead.wanted_um;
  record.tip_um = tick.lead.pipette.tip_um;
  record.pipette_um = pipette_.state().tip_um;
  record.hand_force_N = output.force_N;
  record.contact_force_uN = contact.force_uN;
  record.guide_force_N = hand_from_world(Eigen::Vector3d(force_.part() * tick.lead.fixtures.force_N));
  record.depth_um = contact.depth_um;
  record.contact_age_s = contact.age_s;
  record.contact_frame_index = contact.frame_index;
  record.energy_margin_J = force_.margin_J();
  record.hand_stiffness_N_per_m = force_scale_N_per_uN_ * contact.stiffness_uN_per_um * lead_.scale_um_per_m();
  record.scale_um_per_m = lead_.scale_um_per_m();
  record.limits = acting;
  record.fixtures = tick.lead.fixtures.acting;
  record.buttons = input.hand_read ? input.hand.buttons : 0;
  record.contact_state = contact.state;
  record.hand_state = tick.state;
}

}  // namespace pellucida
