#include "presenters/HandPresenter.h"

#include <algorithm>
#include <cmath>

#include "pellucida/haptics/LimitEvent.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

Phrase state_phrase(HandState state) {
  switch (state) {
    case HandState::kWaiting:
      return {"Waiting", palette::kTextDim};
    case HandState::kWorking:
      return {"Engaged", palette::kHolder};
    case HandState::kClutched:
      return {"Disengaged", palette::kTextDim};
    case HandState::kHeld:
      return {"Held", palette::kWarning};
    case HandState::kStopped:
      return {"Stopped", palette::kRecord};
  }
  return {};
}

Phrase contact_phrase(const HapticRecord& tick) {
  const std::string age = readout::milliseconds(1e3 * tick.contact_age_s) + " old";
  switch (tick.contact_state) {
    case ContactState::kNone:
      return {"No frame yet", palette::kTextDim};
    case ContactState::kFree:
      return {"Free, " + age, palette::kTextDim};
    case ContactState::kContact:
      return {"Contact, " + age, palette::kText};
    case ContactState::kStale:
      return {"Force too old: released", palette::kWarning};
    case ContactState::kInvalid:
      return {"No force measured: released", palette::kWarning};
    case ContactState::kPunctured:
      return {"Punctured, " + age, palette::kText};
  }
  return {};
}

bool acts(const HapticRecord& tick, LimitKind kind) {
  return (tick.limits & limit_bit(kind)) != 0U;
}

// What holds the pipette, and what to do about it.
const char* loss(const HapticRecord& tick) {
  if (acts(tick, LimitKind::kHandLost)) return "Device lost, pipette held: plug it in or choose another hand";
  if (acts(tick, LimitKind::kPipetteLost)) return "Manipulator lost: check its cable and power";
  if (acts(tick, LimitKind::kHandInvalid)) return "Invalid readings from the device: pipette held";
  if (acts(tick, LimitKind::kForceNotFinite)) return "The force could not be computed: no force on the hand";
  if (tick.hand_state == HandState::kStopped) return "Emergency stop: pipette held";
  return nullptr;
}

struct LimitWords {
  LimitKind kind;
  const char* words;
};
// Those the user can act on, the gravest first; the others are in the events and the recording.
constexpr LimitWords kLimits[] = {
    {LimitKind::kBlind, "no deeper while the force is unknown"},
    {LimitKind::kForce, "force on the cell at its limit"},
    {LimitKind::kDepth, "depth limit"},
    {LimitKind::kTravel, "end of travel"},
    {LimitKind::kFollowing, "the pipette lags behind the hand"},
    {LimitKind::kSpeed, "speed limit of the pipette"},
    {LimitKind::kHandForce, "largest force of the device"},
    {LimitKind::kHandStiffness, "stiffer than the device can render"},
    {LimitKind::kPassivity, "damped for stability"},
    {LimitKind::kHandJump, "the hand's reading jumped"},
    {LimitKind::kPipetteJump, "the pipette's report jumped"},
    {LimitKind::kLateTick, "the computer was late"},
};

std::string limit_words(const HapticRecord& tick) {
  std::string text;
  if ((tick.fixtures & kStopBit) != 0U) text = "depth stop";
  for (const LimitWords& limit : kLimits) {
    if (acts(tick, limit.kind)) text += (text.empty() ? "" : ", ") + std::string(limit.words);
  }
  return text;
}

Phrase note_phrase(const HandStatus& status, const std::string& doing) {
  const HapticRecord& tick = status.tick;
  if (status.fault) return {*status.fault, palette::kRecord};
  if (const char* lost = loss(tick)) return {lost, palette::kRecord};
  if (std::string limits = limit_words(tick); !limits.empty()) return {"Limit: " + limits, palette::kWarning};
  if ((tick.fixtures & (kGuideBit | kConeBit)) != 0U) {
    return {doing.empty() ? "Guided" : doing + ", guided", palette::kPlan};
  }
  return {doing, palette::kTextDim};
}

std::string loop_words(const HandStatus& status) {
  if (status.tick_count == 0U) return status.device;
  return status.device + "; 1 kHz: " + status.real_time + "; " + std::to_string(status.tick_count) + " ticks, " +
         std::to_string(status.missed_count) + " missed, 99 % late by at most " +
         readout::number(status.lateness_p99_us, 0) + " \u00b5s; energy margin " +
         readout::number(1e6 * status.tick.energy_margin_J, 0) + " \u00b5J";
}

}  // namespace

HandTexts hand_texts(const HandStatus& status, const std::string& doing) {
  const HapticRecord& tick = status.tick;
  HandTexts texts;
  texts.state = state_phrase(tick.hand_state);
  texts.stopped = tick.hand_state == HandState::kStopped;

  const double force_N = tick.hand_force_N.eigen().norm();
  if (status.max_force_N > 0.0) {
    texts.force_share = std::clamp(force_N / status.max_force_N, 0.0, 1.0);
    texts.force = {readout::number(force_N, 2) + " N of " + readout::number(status.max_force_N, 1) + " N",
                   palette::kText};
  } else if (status.tick_count > 0U) {
    texts.force = {"No force feedback", palette::kTextDim};
  } else {
    texts.force = {"\u2013", palette::kTextDim};
  }
  texts.contact = status.tick_count > 0U ? contact_phrase(tick) : Phrase{"\u2013", palette::kTextDim};
  texts.note = note_phrase(status, doing);
  texts.loop = {loop_words(status), palette::kTextDim};
  return texts;
}

PlanMarks plan_marks(const InjectionPlan& plan, double depth_stop_um, bool guided) {
  const auto in_plane = [](const PlainVector3& v) { return Eigen::Vector2d(v.x, v.y); };
  PlanMarks marks;
  marks.approach_um = in_plane(plan.approach_um);
  marks.entry_um = in_plane(plan.entry_um);
  marks.target_um = in_plane(plan.target_um);
  marks.depth_stop_um = marks.entry_um + depth_stop_um * in_plane(plan.axis);
  marks.corridor_um = plan.options.path_radius_um;
  marks.guided = guided;
  return marks;
}

}  // namespace pellucida
