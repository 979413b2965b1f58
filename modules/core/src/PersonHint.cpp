#include "pellucida/core/PersonHint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "pellucida/core/Error.h"
#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

using Kind = PersonHint::Kind;

// As they are printed; what is read ends at the first number.
constexpr std::array kHintFormats{std::pair{Kind::kCell, PELLUCIDA_WORDS("cell at %.3f %.3f um")},
                                  std::pair{Kind::kNeedleTip, PELLUCIDA_WORDS("needle tip at %.3f %.3f um")},
                                  std::pair{Kind::kNoCell, PELLUCIDA_WORDS("no cell at %.3f %.3f um")}};
constexpr const char* kTakenBack = PELLUCIDA_WORDS("taken back");
constexpr double kDigit_um = 1e-3;

}  // namespace

std::string describe(const PersonHint& hint) {
  for (const auto& [kind, format] : kHintFormats) {
    if (kind != hint.kind) continue;
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), format, hint.x_um, hint.y_um);
    return text.data();
  }
  return kTakenBack;
}

std::optional<PersonHint> hint_of(const Event& event) {
  if (event.kind != event_kind::kHint) return std::nullopt;
  PersonHint hint;
  hint.since_s = event.time_s;
  if (event.detail.starts_with(kTakenBack)) {
    hint.kind = Kind::kTakeBack;
    return hint;
  }
  for (const auto& [kind, format] : kHintFormats) {
    const std::string_view words(format, std::strcspn(format, "%"));
    if (!event.detail.starts_with(words)) continue;
    hint.kind = kind;
    const char* numbers = event.detail.c_str() + words.size();
    if (std::sscanf(numbers, "%lf %lf um", &hint.x_um, &hint.y_um) != 2) return std::nullopt;
    if (!std::isfinite(hint.x_um) || !std::isfinite(hint.y_um)) return std::nullopt;
    return hint;
  }
  return std::nullopt;
}

std::span<const HintOption> hint_options() noexcept {
  static constexpr std::array kOptions{
      HintOption{"--cell-at", Kind::kCell,
                 "X,Y in um: a point inside the cell, in the first frame; X,Y@S: in the first from S seconds on"},
      HintOption{"--needle-tip", Kind::kNeedleTip, "X,Y or X,Y@S: the needle's tip, likewise"},
      HintOption{"--no-cell-at", Kind::kNoCell, "X,Y or X,Y@S: what is there is no cell, from then on"}};
  return kOptions;
}

PersonHint parse_hint(const HintOption& option, const std::string& text) {
  PersonHint hint{.kind = option.kind};
  char rest = 0;
  const bool has_time = text.find('@') != std::string::npos;
  const int read = has_time ? std::sscanf(text.c_str(), "%lf,%lf@%lf%c", &hint.x_um, &hint.y_um, &hint.since_s, &rest)
                            : std::sscanf(text.c_str(), "%lf,%lf%c", &hint.x_um, &hint.y_um, &rest);
  const bool is_finite = std::isfinite(hint.x_um) && std::isfinite(hint.y_um) && std::isfinite(hint.since_s);
  if (read != (has_time ? 3 : 2) || !is_finite) {
    throw UsageError(std::string(option.name) + ' ' + text + ": give X,Y in um, such as 120.5,88, or X,Y@S");
  }
  return as_stored(hint);
}

void add_hints(std::vector<PersonHint>& hints, const HintOption& option, std::span<const std::string> texts) {
  for (const std::string& text : texts) add_in_time(hints, parse_hint(option, text));
}

void add_in_time(std::vector<PersonHint>& hints, const PersonHint& hint) {
  const auto later = std::upper_bound(hints.begin(), hints.end(), hint.since_s,
                                      [](double time_s, const PersonHint& other) { return time_s < other.since_s; });
  hints.insert(later, hint);
}

PersonHint as_stored(PersonHint hint) {
  if (hint.kind == Kind::kTakeBack) hint.x_um = hint.y_um = 0.0;
  hint.x_um = kDigit_um * std::round(hint.x_um / kDigit_um);
  hint.y_um = kDigit_um * std::round(hint.y_um / kDigit_um);
  return hint_of({hint.since_s, event_kind::kHint, describe(hint)}).value_or(hint);
}

}  // namespace pellucida
