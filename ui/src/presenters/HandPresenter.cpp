#include "presenters/HandPresenter.h"

#include <algorithm>
#include <cmath>

#include "pellucida/haptics/LimitEvent.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

Phrase state_phrase(const HapticRecord& tick) {
  switch (tick.hand_state) {
    case HandState::kWaiting:
      return {"Waiting", palette::kTextDim};
    case HandState::kWorking:
      return {"Working", palette::kHolder};
    case HandState::kClutched:
      return {"Hand off", palette::kTextDim};
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
      return {"no frame yet", palette::kTextDim};
    case ContactState::kFree:
      return {"free, " + age, palette::kTextDim};
    case ContactState::kContact:
      return {"contact, " + age, palette::kText};
    case ContactState::kStale:
      return {"too old: released", palette::kWarning};
    case ContactState::kInvalid:
      return {"no force measured: released", palette::kWarning};
    case ContactState::kPunctured:
      return {"punctured, " + age, palette::kText};
  }
  return {};
}

// "depth, hand force", at most three of them.
Phrase limit_phrase(const HapticRecord& tick) {
  std::string text;
  int count = 0;
  for (unsigned k = 0; k < static_cast<unsigned>(LimitKind::kCount); ++k) {
    const auto kind = static_cast<LimitKind>(k);
    if (!(tick.limits & limit_bit(kind)) || ++count > 3) continue;
    text += (text.empty() ? "" : ", ") + std::string(to_string(kind));
  }
  if (!text.empty()) return {"Limit: " + text, palette::kWarning};
  if (tick.fixtures != 0U) return {"Guided", palette::kPlan};
  return {};
}

}  // namespace

HandTexts hand_texts(const HandStatus& status) {
  const HapticRecord& tick = status.tick;
  HandTexts texts;
  texts.state = state_phrase(tick);
  texts.stopped = tick.hand_state == HandState::kStopped;

  const double force_N = tick.hand_force_N.eigen().norm();
  if (status.max_force_N > 0.0) {
    texts.force_share = std::clamp(force_N / status.max_force_N, 0.0, 1.0);
    texts.force = {readout::number(force_N, 2) + " N of " + readout::plain(status.max_force_N) + " N", palette::kText};
  } else {
    texts.force = {"seen, not felt", palette::kTextDim};
  }
  texts.contact = contact_phrase(tick);
  texts.limit = limit_phrase(tick);
  if (status.fault) texts.limit = {*status.fault, palette::kRecord};
  texts.loop = {status.real_time + "; " + std::to_string(status.tick_count) + " ticks, " +
                    std::to_string(status.missed_count) + " missed, 99 % within " +
                    readout::number(status.lateness_p99_us, 0) + " µs; energy margin " +
                    readout::number(1e6 * tick.energy_margin_J, 0) + " µJ",
                palette::kTextDim};
  return texts;
}

}  // namespace pellucida
