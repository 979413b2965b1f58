#include "presenters/HandPresenter.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core/Words.h"
#include "pellucida/haptics/LimitEvent.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

Phrase state_phrase(HandState state) {
  switch (state) {
    case HandState::kWaiting:
      return {say("Waiting"), current_theme().text_dim};
    case HandState::kWorking:
      return {say("Engaged"), current_theme().good};
    case HandState::kClutched:
      return {say("Disengaged"), current_theme().text_dim};
    case HandState::kHeld:
      return {say("Held"), current_theme().warning};
    case HandState::kStopped:
      return {say("Stopped"), current_theme().record};
  }
  return {};
}

Phrase contact_phrase(const HapticRecord& tick) {
  const std::string age = readout::milliseconds(1e3 * tick.contact_age_s) + say(" old");
  switch (tick.contact_state) {
    case ContactState::kNone:
      return {say("No frame yet"), current_theme().text_dim};
    case ContactState::kFree:
      return {say("Free, ") + age, current_theme().text_dim};
    case ContactState::kContact:
      return {say("Contact, ") + age, current_theme().text};
    case ContactState::kStale:
      return {say("Force too old: released"), current_theme().warning};
    case ContactState::kInvalid:
      return {say("No force measured: released"), current_theme().warning};
    case ContactState::kPunctured:
      return {say("Punctured, ") + age, current_theme().text};
  }
  return {};
}

bool acts(const HapticRecord& tick, LimitKind kind) {
  return (tick.limits & limit_bit(kind)) != 0U;
}

// What holds the pipette, and what to do about it.
std::optional<std::string> loss(const HapticRecord& tick) {
  if (acts(tick, LimitKind::kHandLost)) return say("Device lost, pipette held: plug it in or choose another hand");
  if (acts(tick, LimitKind::kPipetteLost)) return say("Manipulator lost: check its cable and power");
  if (acts(tick, LimitKind::kHandInvalid)) return say("Invalid readings from the device: pipette held");
  if (acts(tick, LimitKind::kForceNotFinite)) return say("The force could not be computed: no force on the hand");
  if (tick.hand_state == HandState::kStopped) return say("Emergency stop: pipette held");
  return std::nullopt;
}

// Frame W: z goes into the scene.
Phrase plane_phrase(const PipetteState& pipette) {
  if (!pipette.known) return {"z \u2013", current_theme().text_dim};
  const double z_um = std::abs(pipette.tip_um.z) < 0.05 ? 0.0 : pipette.tip_um.z;
  return {(z_um > 0.0 ? "z +" : "z ") + readout::number(z_um, 1) + " µm", current_theme().text};
}

struct LimitWords {
  LimitKind kind;
  const char* words;
};
// What the demonstration does, in the words of operation/Demonstration; for lupdate.
[[maybe_unused]] constexpr const char* kDoingTexts[] = {PELLUCIDA_WORDS("Looking"),
                                                        PELLUCIDA_WORDS("Approaching"),
                                                        PELLUCIDA_WORDS("Inserting"),
                                                        PELLUCIDA_WORDS("Depositing"),
                                                        PELLUCIDA_WORDS("Taking the needle out"),
                                                        PELLUCIDA_WORDS("Done; a new cell follows"),
                                                        PELLUCIDA_WORDS("Taking the needle out for a new cell"),
                                                        PELLUCIDA_WORDS("Bringing the needle back into view"),
                                                        PELLUCIDA_WORDS("Waiting for an untouched cell")};

// Those the user can act on, the gravest first; the others are in the events and the recording.
constexpr LimitWords kLimits[] = {
    {LimitKind::kBlind, PELLUCIDA_WORDS("no deeper while the force is unknown")},
    {LimitKind::kForce, PELLUCIDA_WORDS("force on the cell at its limit")},
    {LimitKind::kDepth, PELLUCIDA_WORDS("depth limit")},
    {LimitKind::kTravel, PELLUCIDA_WORDS("end of travel")},
    {LimitKind::kFollowing, PELLUCIDA_WORDS("the pipette lags behind the hand")},
    {LimitKind::kSpeed, PELLUCIDA_WORDS("speed limit of the pipette")},
    {LimitKind::kHandForce, PELLUCIDA_WORDS("largest force of the device")},
    {LimitKind::kHandStiffness, PELLUCIDA_WORDS("stiffer than the device can render")},
    {LimitKind::kPassivity, PELLUCIDA_WORDS("damped for stability")},
    {LimitKind::kHandJump, PELLUCIDA_WORDS("the hand's reading jumped")},
    {LimitKind::kPipetteJump, PELLUCIDA_WORDS("the pipette's report jumped")},
    {LimitKind::kLateTick, PELLUCIDA_WORDS("the computer was late")},
};

std::string limit_words(const HapticRecord& tick) {
  std::string text;
  if ((tick.fixtures & kStopBit) != 0U) text = say("depth stop");
  for (const LimitWords& limit : kLimits) {
    if (acts(tick, limit.kind)) text += (text.empty() ? "" : ", ") + say(limit.words);
  }
  return text;
}

Phrase note_phrase(const HandStatus& status, const std::string& doing_english) {
  const std::string doing = say(doing_english.c_str());
  const HapticRecord& tick = status.tick;
  if (status.fault) return {say_message(*status.fault), current_theme().record};
  if (auto lost = loss(tick)) return {std::move(*lost), current_theme().record};
  if (std::string limits = limit_words(tick); !limits.empty())
    return {say("Limit: ") + limits, current_theme().warning};
  if ((tick.fixtures & (kGuideBit | kConeBit)) != 0U) {
    return {doing.empty() ? say("Guided") : doing + say(", guided"), current_theme().plan};
  }
  return {doing, current_theme().text_dim};
}

std::string loop_words(const HandStatus& status) {
  if (status.tick_count == 0U) return say_message(status.device);
  return say_message(status.device) + say("; 1 kHz: ") + say_message(status.real_time) + "; " +
         std::to_string(status.tick_count) + say(" ticks, ") + std::to_string(status.missed_count) +
         say(" missed, 99 % late by at most ") + readout::number(status.lateness_p99_us, 0) +
         say(" \u00b5s; energy margin ") + readout::number(1e6 * status.tick.energy_margin_J, 0) + " \u00b5J";
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
    texts.force = {readout::number(force_N, 2) + say(" N of ") + readout::number(status.max_force_N, 1) + " N",
                   current_theme().text};
  } else if (status.tick_count > 0U) {
    texts.force = {say("No force feedback"), current_theme().text_dim};
  } else {
    texts.force = {"\u2013", current_theme().text_dim};
  }
  texts.contact = status.tick_count > 0U ? contact_phrase(tick) : Phrase{"\u2013", current_theme().text_dim};
  texts.plane = plane_phrase(status.pipette);
  texts.note = note_phrase(status, doing);
  texts.loop = {loop_words(status), current_theme().text_dim};
  return texts;
}

}  // namespace pellucida
