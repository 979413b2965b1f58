#include "pellucida/haptics/LimitLog.h"

namespace pellucida {
namespace {

constexpr double kQuiet_s = 0.1;

}  // namespace

void LimitLog::note(LimitKind kind, double value, double limit) noexcept {
  Kind& noted = kinds_[static_cast<std::size_t>(kind)];
  noted.value = value;
  noted.limit = limit;
}

LimitLog::Changes LimitLog::update(double now_s, std::uint32_t acting) noexcept {
  Changes changes;
  for (std::size_t k = 0; k < kKindCount; ++k) {
    Kind& kind = kinds_[k];
    const bool acts = (acting & (std::uint32_t{1} << k)) != 0;
    if (acts) kind.last_s = now_s;
    const bool ended = kind.begun && !acts && now_s - kind.last_s >= kQuiet_s;
    const bool begins = acts && !kind.begun;
    if (!begins && !ended) continue;
    kind.begun = begins;
    changes.events[changes.count++] = {now_s, static_cast<LimitKind>(k), begins, kind.value, kind.limit};
  }
  return changes;
}

}  // namespace pellucida
